#include "solver/mesh/shapes/GeodesicSphere.h"
#include "solver/stokes/SingleLayer.h"

#include "solver/stokes/LayerModes.h"
#include "tests/solver/support/TestMeshes.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <functional>

namespace vesicle
{
namespace
{

using test::jittered_sphere;
using test::mapped;
using Field = std::function<Vector3(const Vector3&)>;

struct Case
{
  TriangleMesh mesh;
  DenseMatrix S;
  Eigen::VectorXd areas;
  explicit Case(TriangleMesh m, int quadrature = 3) : mesh(std::move(m))
  {
    const LinearBasis basis(mesh.triangles, static_cast<int>(mesh.points.rows()));
    const SingleLayer layer(basis, { quadrature });
    layer.assemble(mesh.points, mesh.points, S);
    areas = vertex_areas(layer.table(), evaluate(layer.table(), mesh.points));
  }
  Eigen::VectorXd nodal(const Field& field) const
  {
    Eigen::VectorXd f(3 * mesh.points.rows());
    for (int i = 0; i < mesh.points.rows(); ++i)
      f.segment<3>(3 * i) = field(mesh.points.row(i).transpose());
    return f;
  }
  // Relative error of S f against factor · f.
  double eigen_error(const Field& field, double factor) const
  {
    const Eigen::VectorXd f = nodal(field);
    Eigen::VectorXd u;
    multiply(S, f, u);
    return (u - factor * f).norm() / (factor * f).norm();
  }
};

TEST(SingleLayer, SphereEigenvaluesWithOrderTwo)
{
  const Case coarse(geodesic_sphere(4)), fine(geodesic_sphere(8));
  for (const LayerMode& mode : sphere_layer_modes())
  {
    const double e0 = coarse.eigen_error(mode.field, mode.eigenvalue);
    const double e1 = fine.eigen_error(mode.field, mode.eigenvalue);
    EXPECT_GT(test::order(e0, e1), 1.7) << mode.name << ": " << e0 << ", " << e1;
    EXPECT_LT(e1, 0.03) << mode.name;
  }
}

TEST(SingleLayer, SphereEigenvaluesOnAnIrregularMesh)
{
  const Case coarse(jittered_sphere(4, 0.25)), fine(jittered_sphere(8, 0.25));
  for (const LayerMode& mode : sphere_layer_modes())
  {
    const double e0 = coarse.eigen_error(mode.field, mode.eigenvalue);
    const double e1 = fine.eigen_error(mode.field, mode.eigenvalue);
    EXPECT_GT(test::order(e0, e1), 1.5) << mode.name << ": " << e0 << ", " << e1;
  }
}

TEST(SingleLayer, PressureMovesNothing)
{
  double speed[2];
  for (int level = 0; level < 2; ++level)
  {
    const Case c(geodesic_sphere(level == 0 ? 4 : 8));
    Eigen::VectorXd u;
    multiply(c.S, c.nodal([](const Vector3& x) { return x; }), u);
    speed[level] = u.cwiseAbs().maxCoeff();
  }
  EXPECT_GT(test::order(speed[0], speed[1]), 1.5);
  EXPECT_LT(speed[1], 1e-3);
}

// Drag of the ellipsoid 2, 1, 1 translating at unit speed: ∮ f dS with S f = e (Happel & Brenner
// 5-11).
TEST(SingleLayer, DragOfAnEllipsoid)
{
  const double exact[] = { 22.693753013, 25.991634884 };
  double error[2][2];
  for (int level = 0; level < 2; ++level)
  {
    const Case c(mapped(geodesic_sphere(level == 0 ? 3 : 6), test::ellipsoid_2_1_1));
    const Eigen::PartialPivLU<Eigen::MatrixXd> lu(c.S);
    for (int axis = 0; axis < 2; ++axis)
    {
      const Eigen::VectorXd f =
        lu.solve(c.nodal([&](const Vector3&) { return Vector3::Unit(axis); }));
      double drag = 0;
      for (int i = 0; i < c.areas.size(); ++i)
        drag += c.areas[i] * f[3 * i + axis];
      error[level][axis] = std::abs(drag / exact[axis] - 1);
    }
  }
  for (int axis = 0; axis < 2; ++axis)
  {
    EXPECT_LT(error[1][axis], 0.01) << axis;
    EXPECT_GT(test::order(error[0][axis], error[1][axis]), 1.7)
      << error[0][axis] << ", " << error[1][axis];
  }
}

// The matrices of the dynamics are combinations of the whole one.
TEST(SingleLayer, ResponsesAreThoseOfTheWholeMatrix)
{
  const TriangleMesh mesh = mapped(jittered_sphere(4, 0.2), test::paper_surface);
  const int n = static_cast<int>(mesh.points.rows());
  const LinearBasis basis(mesh.triangles, n);
  const SingleLayer layer(basis, {});
  const SurfacePoints surface = evaluate(layer.table(), mesh.points);
  DenseMatrix S;
  layer.assemble(mesh.points, mesh.points, S);
  const Points normal = basis.vertex_normals(mesh.points);
  const SparseMatrix T = area_rate_matrix(layer.table(), surface).transpose();
  const Eigen::VectorXd load = Eigen::VectorXd::LinSpaced(3 * n, -1, 1);
  VelocityResponse response;
  layer.respond(mesh.points, normal, true, T, load, response);

  const Eigen::VectorXd phi = Eigen::VectorXd::LinSpaced(n, 0, 1).array().cos();
  const Eigen::VectorXd gamma = Eigen::VectorXd::LinSpaced(n, 0, 2).array().sin();
  Eigen::VectorXd density = T * gamma;
  for (int i = 0; i < n; ++i)
    density.segment<3>(3 * i) += phi[i] * normal.row(i).transpose();
  const Eigen::VectorXd u = S * density;
  EXPECT_LT((response.velocity(phi, gamma) - u).norm(), 1e-13 * u.norm());
  EXPECT_LT((response.load - S * load).norm(), 1e-13 * (S * load).norm());
}

TEST(SingleLayer, DoesNotChangeWithRenumbering)
{
  const TriangleMesh mesh = mapped(jittered_sphere(3, 0.2), test::paper_surface);
  const auto [other, order] = test::renumbered(mesh);
  const Case a(mesh), b(other);
  double difference = 0;
  for (int i = 0; i < a.areas.size(); ++i)
    for (int k = 0; k < a.areas.size(); ++k)
      difference = std::max(difference,
        (b.S.block<3, 3>(3 * i, 3 * k) - a.S.block<3, 3>(3 * order[i], 3 * order[k]))
          .cwiseAbs()
          .maxCoeff());
  // Corners are cyclically shifted, which exchanges equal quadrature points: only rounding is left.
  EXPECT_LT(difference, 1e-15);
}

}
}
