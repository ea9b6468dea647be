#include "solver/surface/LoopCurvature.h"

#include "solver/Errors.h"
#include "solver/mesh/shapes/GeodesicSphere.h"
#include "solver/surface/Surface.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace vesicle
{
namespace
{

TriangleMesh ellipsoid()
{
  return test::mapped(test::jittered_sphere(16, 0.2), test::ellipsoid_2_1_1);
}

double difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
  return (a - b).norm() / b.norm();
}

}

TEST(LoopCurvature, IsThatOfTheDynamics)
{
  // By iterations here, by factors there: both to rounding, which second differences over edges of
  // 0.1 amplify, fourth ones once more.
  const TriangleMesh mesh = ellipsoid();
  const SurfaceSpace space(
    SurfaceBasis::loop, mesh.triangles, static_cast<int>(mesh.points.rows()));
  const Curvature expected = vertex_curvature(Surface(space, mesh.points));
  const Curvature c = loop_curvature(mesh);
  EXPECT_LT(difference(c.normal, expected.normal), 1e-12);
  EXPECT_LT(difference(c.mean, expected.mean), 1e-11);
  EXPECT_LT(difference(c.gauss, expected.gauss), 1e-11);
  EXPECT_LT(difference(c.laplacian_mean, expected.laplacian_mean), 1e-9);
}

TEST(LoopCurvature, DoesNotDependOnTheNumberOfThreads)
{
  const TriangleMesh mesh = ellipsoid();
  const Curvature many = loop_curvature(mesh);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const Curvature single = loop_curvature(mesh);
  EXPECT_EQ(many.mean, single.mean);
  EXPECT_EQ(many.gauss, single.gauss);
  EXPECT_EQ(many.laplacian_mean, single.laplacian_mean);
}

TEST(LoopCurvature, TellsItsProgressAndCanBeEnded)
{
  const TriangleMesh mesh = ellipsoid();
  std::vector<double> shares;
  loop_curvature(mesh, [&](double share) { shares.push_back(share); });
  EXPECT_GT(shares.size(), 2U);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_LE(shares.back(), 1);
  EXPECT_THROW(
    loop_curvature(mesh, [](double) { throw std::runtime_error("stop"); }), std::runtime_error);
}

TEST(LoopCurvature, NeedsAClosedMesh)
{
  TriangleMesh mesh = geodesic_sphere(2);
  mesh.triangles.conservativeResize(mesh.triangles.rows() - 1, 3);
  EXPECT_THROW(loop_curvature(mesh), InputError);
}

}
