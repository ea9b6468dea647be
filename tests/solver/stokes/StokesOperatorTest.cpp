#include "solver/mesh/shapes/GeodesicSphere.h"
#include "solver/stokes/StokesOperator.h"

#include "solver/stokes/LayerModes.h"
#include "solver/stokes/LayerSum.h"
#include "solver/stokes/TreeSum.h"
#include "solver/surface/LoopBasis.h"
#include "solver/surface/Surface.h"
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
    const LayerRules rules(basis, { quadrature });
    S = StokesOperator({ { &rules, mesh.points, mesh.points } }).matrix(0);
    const BasisTable& table = rules.regular().table;
    areas = vertex_areas(table, evaluate(table, mesh.points));
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
    const Eigen::VectorXd u = multiply(S, f);
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
    const Eigen::VectorXd u = multiply(c.S, c.nodal([](const Vector3& x) { return x; }));
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

// Columns of nodal densities are combinations of the whole matrix's, and what is applied without a
// matrix is the same.
TEST(StokesOperator, ColumnsAndApplicationAreThoseOfTheWholeMatrix)
{
  const TriangleMesh mesh = mapped(jittered_sphere(4, 0.2), test::paper_surface);
  const int n = static_cast<int>(mesh.points.rows());
  const LinearBasis basis(mesh.triangles, n);
  const LayerRules rules(basis, {});
  const StokesOperator layer({ { &rules, mesh.points, mesh.points } });
  const BasisTable& table = rules.regular().table;
  const SparseMatrix T = area_rate_matrix(table, evaluate(table, mesh.points)).transpose();
  const DenseMatrix S = layer.matrix(0);
  const Eigen::VectorXd gamma = Eigen::VectorXd::LinSpaced(n, 0, 2).array().sin();
  const Eigen::VectorXd u = S * (T * gamma);
  EXPECT_LT((multiply(layer.columns(0, NodalDensities{ T }), gamma) - u).norm(), 1e-13 * u.norm());
  const Points nodal = Eigen::VectorXd(T * gamma).reshaped<Eigen::RowMajor>(n, 3);
  const Eigen::VectorXd applied = layer.apply(std::array{ nodal_density(nodal) });
  EXPECT_LT((applied - u).norm(), 1e-13 * u.norm());
}

// Two surfaces of different size, neither a multiple of the lanes, one loaded at a time.
TEST(LayerSum, IsTheWholeMatrixAppliedOnFlatTriangles)
{
  const TriangleMesh large = mapped(jittered_sphere(4, 0.2), test::paper_surface);
  TriangleMesh small = jittered_sphere(2, 0.2);
  small.points.rowwise() += Eigen::RowVector3d(3, 0, 0);
  const LinearBasis large_basis(large.triangles, static_cast<int>(large.points.rows())),
    small_basis(small.triangles, static_cast<int>(small.points.rows()));
  const LayerRules of_large(large_basis, {}), of_small(small_basis, {});
  const std::vector<LayerSurface> surfaces{ { &of_large, large.points, large.points },
    { &of_small, small.points, small.points } };
  const StokesOperator layer(surfaces);
  const LayerSum sum(layer);
  for (int source = 0; source < 2; ++source)
  {
    const DenseMatrix S = layer.matrix(source);
    const Eigen::VectorXd f = Eigen::VectorXd::LinSpaced(S.cols(), 0, 40).array().sin(), u = S * f;
    std::vector<Eigen::VectorXd> densities{ Eigen::VectorXd::Zero(large.points.size()),
      Eigen::VectorXd::Zero(small.points.size()) };
    densities[source] = f;
    EXPECT_LT((sum.apply(densities) - u).norm(), 1e-13 * u.norm()) << source;
    EXPECT_LT((multiply(S, f) - u).norm(), 1e-14 * u.norm()) << source;
  }
}

// Two surfaces on which near, graded and singular rules differ, neither a multiple of the lanes.
TEST(LayerSum, IsTheWholeMatrixApplied)
{
  const TriangleMesh large = mapped(jittered_sphere(4, 0.2), test::paper_surface);
  TriangleMesh small = jittered_sphere(2, 0.2);
  small.points.rowwise() += Eigen::RowVector3d(3, 0, 0);
  const auto basis_of = [](const TriangleMesh& mesh)
  { return LoopBasis(mesh.triangles, static_cast<int>(mesh.points.rows())); };
  const LoopBasis of_large = basis_of(large), of_small = basis_of(small);
  for (const int points : { 3, 6 })
  {
    const LayerRules first(of_large, layer_quadrature(of_large, points)),
      second(of_small, layer_quadrature(of_small, points));
    const std::vector<LayerSurface> surfaces{ { &first, large.points,
                                                Collocation(of_large).fit(large.points) },
      { &second, small.points, Collocation(of_small).fit(small.points) } };
    const StokesOperator layer(surfaces);
    const LayerSum sum(layer);
    std::vector<Eigen::VectorXd> densities;
    Eigen::VectorXd u = Eigen::VectorXd::Zero(3 * layer.vertices());
    for (int source = 0; source < 2; ++source)
    {
      const DenseMatrix S = layer.matrix(source);
      densities.emplace_back(Eigen::VectorXd::LinSpaced(S.cols(), 0, 40).array().sin());
      u += S * densities.back();
    }
    EXPECT_LT((sum.apply(densities) - u).norm(), 1e-13 * u.norm()) << points;
    EXPECT_LT(
      (sum.apply(densities, single_precision_error) - u).norm(), single_precision_error * u.norm())
      << points;
    const LayerSum by_tree(
      layer, [](const PointPlaces& places) { return std::make_unique<TreeSum>(places, 1e-7); });
    EXPECT_LT((by_tree.apply(densities) - u).norm(), 1e-7 * u.norm()) << points;
  }
}

// The unit sphere under the load z n, λ = 1: 4/15 alone, times 1 + 5/(4d) − 1/(2d³) beside another
// at the distance d along z (before they deform).
TEST(StokesOperator, TwoLoadedSpheresHelpEachOther)
{
  const double d = 2.5, exact = 4. / 15 * (1 + 5 / (4 * d) - 1 / (2 * d * d * d));
  double error[2];
  for (int level = 0; level < 2; ++level)
  {
    const TriangleMesh mesh = test::smooth_sphere(level == 0 ? 80 : 320);
    const LoopBasis basis(mesh.triangles, static_cast<int>(mesh.points.rows()));
    const LayerRules rules(basis, layer_quadrature(basis, 6));
    const SurfaceSpace space(
      SurfaceBasis::loop, mesh.triangles, static_cast<int>(mesh.points.rows()));
    std::vector<LayerSurface> spheres;
    std::vector<ForceDensity> loads;
    for (const double z : { 0., d })
    {
      const Points points = mesh.points.rowwise() + Eigen::RowVector3d(0, 0, z);
      spheres.push_back({ &rules, points, space.collocation().fit(points) });
      loads.push_back(normal_density(space.collocation().fit(mesh.points.col(2))));
    }
    const Eigen::VectorXd u = StokesOperator(std::move(spheres)).apply(loads);
    const Surface sphere(space, mesh.points);
    error[level] = 0;
    for (const Eigen::VectorXd& own :
      { Eigen::VectorXd(u.head(u.size() / 2)), Eigen::VectorXd(u.tail(u.size() / 2)) })
      error[level] = std::max(error[level], std::abs(sphere.mean_velocity(own).z() / exact - 1));
  }
  EXPECT_LT(error[1], 1e-3);
  EXPECT_GT(test::order(error[0], error[1]), 2) << error[0] << ", " << error[1];
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
