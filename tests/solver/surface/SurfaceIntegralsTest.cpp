#include "solver/mesh/MeshIntegrals.h"
#include "solver/mesh/shapes/GeodesicSphere.h"
#include "solver/surface/SurfaceIntegrals.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

#include <numbers>

namespace vesicle
{
namespace
{

using test::ellipsoid_2_1_1;
using test::jittered_sphere;
using test::mapped;

struct Case
{
  TriangleMesh mesh;
  BasisTable table;
  SurfacePoints surface;

  explicit Case(TriangleMesh m)
    : mesh(std::move(m)),
      table(tabulate_rule(
        LinearBasis(mesh.triangles, static_cast<int>(mesh.points.rows())), triangle_rule(3))),
      surface(evaluate(table, mesh.points))
  {
  }
  SurfacePoints at(const Points& points) const { return evaluate(table, points); }
};

Case irregular_ellipsoid()
{
  return Case(mapped(jittered_sphere(4, 0.25), ellipsoid_2_1_1));
}

// A smooth field that is neither rigid nor special to the ellipsoid.
Eigen::VectorXd smooth_field(const Points& points)
{
  Eigen::VectorXd u(points.size());
  for (int i = 0; i < points.rows(); ++i)
  {
    const Vector3 x = points.row(i);
    u.segment<3>(3 * i) << std::sin(x.y()) + x.x() * x.z(), x.x() * x.x() - x.z(),
      x.y() * x.z() + 1;
  }
  return u;
}

Points moved(const Points& points, const Eigen::VectorXd& u, double step)
{
  return points + step * Eigen::Map<const Points>(u.data(), points.rows(), 3);
}

// Central difference of a functional of the points along u.
template<class Functional>
double slope(const Case& c, const Eigen::VectorXd& u, Functional f)
{
  const double step = 1e-5;
  return (f(c.at(moved(c.mesh.points, u, step))) - f(c.at(moved(c.mesh.points, u, -step)))) /
    (2 * step);
}

TEST(Surface, AreaAndVolumeAreThoseOfTheFlatTriangles)
{
  const Case c = irregular_ellipsoid();
  EXPECT_NEAR(area(c.surface), flat_area(c.mesh), 1e-12);
  EXPECT_NEAR(volume(c.table, c.surface), flat_volume(c.mesh), 1e-12);
  EXPECT_LT((centroid(c.table, c.surface) - volume_centroid(c.mesh)).norm(), 1e-12);
  EXPECT_NEAR(vertex_areas(c.table, c.surface).sum(), area(c.surface), 1e-12);
}

TEST(Surface, AreaAndVolumeOfASphereConvergeAsHSquared)
{
  const Case coarse(geodesic_sphere(4)), fine(geodesic_sphere(8));
  const double sphere = 4 * std::numbers::pi;
  EXPECT_NEAR(test::order(sphere - area(coarse.surface), sphere - area(fine.surface)), 2, 0.05);
  EXPECT_NEAR(test::order(sphere / 3 - volume(coarse.table, coarse.surface),
                sphere / 3 - volume(fine.table, fine.surface)),
    2, 0.05);
}

TEST(Surface, AreaRatesAreTheDerivativeOfTheVertexAreas)
{
  const Case c = irregular_ellipsoid();
  const Eigen::VectorXd u = smooth_field(c.mesh.points);
  const Eigen::VectorXd rate = area_rate_matrix(c.table, c.surface) * u;
  for (int k : { 0, 7, 40, 100, 161 })
    EXPECT_NEAR(rate[k],
      slope(c, u, [&](const SurfacePoints& s) { return vertex_areas(c.table, s)[k]; }), 1e-8);
}

TEST(Surface, RigidMotionsChangeNoVertexArea)
{
  const Case c = irregular_ellipsoid();
  const SparseMatrix B = area_rate_matrix(c.table, c.surface);
  Eigen::VectorXd u(c.mesh.points.size());
  for (int i = 0; i < c.mesh.points.rows(); ++i)
    u.segment<3>(3 * i) =
      Vector3(1, -2, 0.5) + Vector3(0.3, 1, -0.7).cross(Vector3(c.mesh.points.row(i).transpose()));
  EXPECT_LT((B * u).cwiseAbs().maxCoeff(), 1e-14);
  // The transpose then gives forces without resultant and moment, whatever the tension.
  const Eigen::VectorXd tension = smooth_field(c.mesh.points).head(c.mesh.points.rows());
  EXPECT_NEAR(u.dot(B.transpose() * tension), 0, 1e-12);
}

TEST(Surface, VolumeGradientIsTheDerivativeOfTheVolume)
{
  const Case c = irregular_ellipsoid();
  const Eigen::VectorXd u = smooth_field(c.mesh.points);
  EXPECT_NEAR(volume_gradient(c.table, c.surface).dot(u),
    slope(c, u, [&](const SurfacePoints& s) { return volume(c.table, s); }), 1e-8);
}

TEST(Surface, CentroidVelocityIsTheDerivativeOfTheCentroidForVolumeKeepingMotion)
{
  const Case c = irregular_ellipsoid();
  const Eigen::VectorXd gradient = volume_gradient(c.table, c.surface);
  Eigen::VectorXd u = smooth_field(c.mesh.points);
  u -= gradient.dot(u) / gradient.squaredNorm() * gradient;
  const Vector3 velocity = centroid_velocity_matrix(c.table, c.surface) * u;
  for (int d = 0; d < 3; ++d)
    EXPECT_NEAR(velocity[d],
      slope(c, u, [&](const SurfacePoints& s) { return centroid(c.table, s)[d]; }), 1e-8);
}

// ∮ z n dS = V e_z, ∮ n dS = 0 and no moment about a vertical axis: exact on the discrete surface.
TEST(Surface, BuoyancyHasTheExactResultant)
{
  const Case c = irregular_ellipsoid();
  const Eigen::VectorXd load = normal_load(c.table, c.surface, c.surface.position.col(2));
  Vector3 force = Vector3::Zero(), moment = Vector3::Zero();
  for (int i = 0; i < c.mesh.points.rows(); ++i)
  {
    force += load.segment<3>(3 * i);
    moment += Vector3(c.mesh.points.row(i)).cross(Vector3(load.segment<3>(3 * i)));
  }
  const double V = volume(c.table, c.surface);
  EXPECT_LT((force - V * Vector3::UnitZ()).norm(), 1e-12);
  const Vector3 expected = centroid(c.table, c.surface).cross(V * Vector3::UnitZ());
  EXPECT_LT((moment - expected).norm(), 1e-12);
}

TEST(Surface, DoesNotDependOnWhereTheVesicleIs)
{
  Case here = irregular_ellipsoid();
  TriangleMesh far = here.mesh;
  far.points.rowwise() += Eigen::RowVector3d(1e4, -2e4, 3e4);
  const Case there(far);
  EXPECT_NEAR(volume(there.table, there.surface), volume(here.table, here.surface), 1e-9);
  EXPECT_LT(
    (volume_gradient(there.table, there.surface) - volume_gradient(here.table, here.surface))
      .cwiseAbs()
      .maxCoeff(),
    1e-9);
}

}
}
