#include "solver/surface/FitRadius.h"

#include "solver/mesh/shapes/GeodesicSphere.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace vesicle
{
namespace
{

Connectivity connectivity_of(const TriangleMesh& mesh)
{
  return { mesh.triangles, static_cast<int>(mesh.points.rows()) };
}

TriangleMesh noisy_sphere(int n, double deviation)
{
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, deviation);
  TriangleMesh mesh = geodesic_sphere(n);
  for (int i = 0; i < mesh.points.rows(); ++i)
    mesh.points.row(i) *= 1 + noise(random);
  return mesh;
}

/// Of H on the unit sphere.
double deviation(const FittedCurvature& fit)
{
  return std::sqrt((fit.curvature.mean.array() - 1).square().mean());
}

double error(const TriangleMesh& mesh, double radius = 0)
{
  return typical_error(mesh, fitted_curvature(mesh, connectivity_of(mesh), { radius, false }));
}

}

// The meshes' errors of H are known from the tests of FittedCurvature: 2.0e-3 at 1,280 triangles.
TEST(FitRadius, SmoothMeshesHaveASmallError)
{
  EXPECT_LT(error(geodesic_sphere(8)), 0.01);
  EXPECT_LT(error(test::mapped(test::jittered_sphere(8, 0.3), test::ellipsoid_2_1_1)), 0.01);
  EXPECT_LT(error(test::mapped(geodesic_sphere(8),
              [](const Vector3& x) -> Vector3 {
                return { x[0], x[1], 0 };
              })),
    1e-6)
    << "flat";
}

// Of independent noise the standard error is the deviation.
TEST(FitRadius, TheErrorIsThatOfTheNoise)
{
  for (const double noise : { 1e-4, 3e-4 })
  {
    const TriangleMesh mesh = noisy_sphere(16, noise);
    const FittedCurvature fit = fitted_curvature(mesh);
    const double expected = std::sqrt(fit.mean_error.squaredNorm() / fit.mean_error.size());
    testing::Test::RecordProperty("ratio", std::to_string(deviation(fit) / expected));
    EXPECT_NEAR(deviation(fit) / expected, 1, 0.1);
    EXPECT_NEAR(error(mesh), deviation(fit), 0.2 * deviation(fit)) << "the median is less";
  }
}

TEST(FitRadius, TheRadiusGivesTheErrorAskedFor)
{
  for (const double noise : { 3e-3, 1e-2 }) // of edges of 0.035
  {
    const TriangleMesh mesh = noisy_sphere(32, noise);
    EXPECT_GT(error(mesh), 0.3);
    const auto radius = radius_for_error(mesh, connectivity_of(mesh), 0.03);
    ASSERT_TRUE(radius);
    testing::Test::RecordProperty("radius_" + std::to_string(noise), std::to_string(*radius));
    const FittedCurvature fit = fitted_curvature(mesh, connectivity_of(mesh), { *radius, false });
    EXPECT_LE(typical_error(mesh, fit), 0.03 * 1.1) << "judged by a sample there";
    EXPECT_GT(typical_error(mesh, fit), 0.03 / 4)
      << "it isn't much too large: a step is 1.6 at most";
    EXPECT_NEAR(deviation(fit), typical_error(mesh, fit), 0.3 * typical_error(mesh, fit));
  }
}

TEST(FitRadius, NoneForACoarseMesh)
{
  const TriangleMesh coarse = geodesic_sphere(1);
  EXPECT_FALSE(radius_for_error(coarse, connectivity_of(coarse)));
  const TriangleMesh nothing{ Points(0, 3), Triangles(0, 3) };
  EXPECT_FALSE(radius_for_error(nothing, connectivity_of(nothing)));
  EXPECT_EQ(error(nothing), 0);
}

}
