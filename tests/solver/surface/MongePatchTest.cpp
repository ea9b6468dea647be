#include "solver/surface/MongePatch.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vesicle::test
{
namespace
{

constexpr double radius = 2;

/// The upper half of a sphere at (x, y), in tilted axes.
MongePatch sphere(double x, double y)
{
  const double z = std::sqrt(radius * radius - x * x - y * y);
  return { frame_along(Vector3(1, 2, 3).normalized()),
    { -x / z, -y / z, -1 / z - x * x / (z * z * z), -x * y / (z * z * z),
      -1 / z - y * y / (z * z * z) } };
}

/// The upper half of a cylinder along y.
MongePatch cylinder(double x)
{
  const double z = std::sqrt(radius * radius - x * x);
  return { Eigen::Matrix3d::Identity(), { -x / z, 0, -radius * radius / (z * z * z), 0, 0 } };
}

}

TEST(MongePatch, OfASphereAndACylinder)
{
  const MongePatch round = sphere(0.7, -1.1);
  EXPECT_NEAR(round.mean(), 1 / radius, 1e-14);
  EXPECT_NEAR(round.gauss(), 1 / (radius * radius), 1e-14);
  const Vector3 outward(0.7 / radius, -1.1 / radius, std::sqrt(radius * radius - 1.7) / radius);
  EXPECT_LT((round.frame * round.normal() - outward).norm(), 1e-14);
  EXPECT_NEAR(cylinder(1.5).mean(), 0.5 / radius, 1e-14);
  EXPECT_NEAR(cylinder(1.5).gauss(), 0, 1e-14);
}

TEST(MongePatch, TheGreatestCurvatureIsAroundTheCylinder)
{
  for (const double x : { -1.5, 0., 1.5 })
  {
    MongePatch patch = cylinder(x);
    const Vector3 around(std::sqrt(radius * radius - x * x) / radius, 0, -x / radius);
    EXPECT_LT(patch.direction().cross(around).norm(), 1e-14);
    EXPECT_NEAR(patch.direction().norm(), 1, 1e-14);
    patch.slope.tail<3>() *= -1; // seen from within: along it
    EXPECT_LT(patch.direction().cross(Vector3::UnitY()).norm(), 1e-14);
  }
}

TEST(MongePatch, TheSaddlesDirections)
{
  const MongePatch saddle{ Eigen::Matrix3d::Identity(), { 0, 0, 0, 1, 0 } }; // z = xy
  EXPECT_LT(saddle.direction().cross(Vector3(1, -1, 0)).norm(), 1e-14);
  EXPECT_GT(saddle.direction().maxCoeff(), 0);
}

// Δ_s x = −2 H n for the coordinates themselves.
TEST(MongePatch, LaplacianOfTheCoordinates)
{
  const MongePatch patch = sphere(0.7, -1.1);
  const Eigen::Vector<double, 5> l = patch.laplacian();
  const Vector3 expected = -2 * patch.mean() * (patch.frame * patch.normal());
  EXPECT_NEAR(l[0], expected.x(), 1e-14);
  EXPECT_NEAR(l[1], expected.y(), 1e-14);
  EXPECT_NEAR(l.dot(patch.slope), expected.z(), 1e-14);
}

}
