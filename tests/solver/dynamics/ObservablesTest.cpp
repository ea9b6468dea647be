#include "solver/dynamics/Observables.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

#include <numbers>

namespace vesicle
{
namespace
{

using test::mapped;

TriangleMesh turned_ellipsoid(double degrees)
{
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(-degrees * std::numbers::pi / 180, Vector3::UnitY()).toRotationMatrix();
  return mapped(geodesic_sphere(8),
    [&](const Vector3& d) -> Vector3
    { return turn * Vector3(1.5 * d.x(), 1.1 * d.y(), 0.8 * d.z()); });
}

TEST(Observables, SemiAxesOfAnEllipsoid)
{
  const InertiaEllipsoid e = inertia_ellipsoid(turned_ellipsoid(30));
  // The flat mesh is inscribed: each axis is short by about h²/16 of it.
  EXPECT_NEAR(e.semi_axes[0], 1.5, 0.008);
  EXPECT_NEAR(e.semi_axes[1], 1.1, 0.006);
  EXPECT_NEAR(e.semi_axes[2], 0.8, 0.005);
}

TEST(Observables, InclinationIsCountedFromXTowardsZInHalfOpenRange)
{
  for (double degrees : { -89., -45., 0., 30., 89. })
  {
    const InertiaEllipsoid e = inertia_ellipsoid(turned_ellipsoid(degrees));
    ASSERT_TRUE(e.inclination_deg);
    EXPECT_NEAR(*e.inclination_deg, degrees, 1e-6);
    EXPECT_NEAR(*e.tilt_deg, 90 - std::abs(degrees), 1e-6);
  }
}

TEST(Observables, ASphereHasNoDirection)
{
  const InertiaEllipsoid e = inertia_ellipsoid(geodesic_sphere(4));
  EXPECT_FALSE(e.inclination_deg);
  EXPECT_FALSE(e.tilt_deg);
}

// A rigid rotation of a sphere about y takes 2π/ω; seen from a moving frame it does too.
TEST(Observables, TankTreadingFrequencyOfARotation)
{
  const Vector3 frame(0.3, 0, -2);
  const TriangleMesh sphere = geodesic_sphere(8);
  Points u(sphere.points.rows(), 3);
  for (int i = 0; i < u.rows(); ++i)
    u.row(i) = (frame + Vector3(0, 0.7, 0).cross(Vector3(sphere.points.row(i)))).transpose();
  EXPECT_NEAR(tank_treading_frequency(sphere, u, Vector3::Zero(), frame), 0.7, 0.005);
  EXPECT_NEAR(tank_treading_frequency(sphere, -u, Vector3::Zero(), -frame), 0.7, 0.005);
}

TEST(Observables, NoFrequencyWhereTheFlowDoesNotGoAround)
{
  const TriangleMesh sphere = geodesic_sphere(6);
  EXPECT_EQ(tank_treading_frequency(
              sphere, Points::Zero(sphere.points.rows(), 3), Vector3::Zero(), Vector3::Zero()),
    0);
  Points strain = sphere.points;
  strain.col(2) *= -1;
  EXPECT_EQ(tank_treading_frequency(sphere, strain, Vector3::Zero(), Vector3::Zero()), 0);
}

}
}
