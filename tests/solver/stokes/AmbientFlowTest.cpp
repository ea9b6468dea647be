#include "solver/stokes/AmbientFlow.h"

#include <gtest/gtest.h>

namespace vesicle
{
namespace
{

using Kind = Scene::Flow::Kind;

Vector3 at(const Scene::Flow& flow, const Vector3& x)
{
  Points p(1, 3);
  p.row(0) = x.transpose();
  return ambient_velocity(flow, p).row(0).transpose();
}

Scene::Flow flow(Kind kind)
{
  Scene::Flow f;
  f.kind = kind;
  f.rate = 2;
  f.velocity = { 1, 2, 3 };
  f.speed = 3;
  f.radius = 4;
  f.axis = { 0, 0, 2 };
  f.center = { 1, 0, 5 };
  return f;
}

TEST(AmbientFlow, IsWhatTheSceneSays)
{
  const Vector3 x(0.5, -1, 2);
  EXPECT_EQ(at(flow(Kind::uniform), x), Vector3(1, 2, 3));
  EXPECT_EQ(at(flow(Kind::shear), x), Vector3(4, 0, 0));
  EXPECT_EQ(at(flow(Kind::planar_extension), x), Vector3(1, 0, -4));
  EXPECT_EQ(at(flow(Kind::axisymmetric_extension), x), Vector3(-0.5, 1, 4));
  // 3 (1 − d²/16) along z, d² = 0.25 + 1.
  EXPECT_LT((at(flow(Kind::poiseuille), x) - Vector3(0, 0, 3 * (1 - 1.25 / 16))).norm(), 1e-14);
}

TEST(AmbientFlow, IsIncompressible)
{
  for (Kind kind : { Kind::uniform, Kind::shear, Kind::planar_extension,
         Kind::axisymmetric_extension, Kind::poiseuille })
  {
    const double h = 1e-4;
    double divergence = 0;
    for (int d = 0; d < 3; ++d)
    {
      const Vector3 e = h * Vector3::Unit(d), x(0.3, 0.7, -0.2);
      divergence += (at(flow(kind), x + e) - at(flow(kind), x - e))[d] / (2 * h);
    }
    EXPECT_NEAR(divergence, 0, 1e-9);
  }
}

TEST(AmbientFlow, ScalesLikeVelocity)
{
  const double length = 1e-6, velocity = 1e-4;
  for (Kind kind : { Kind::uniform, Kind::shear, Kind::planar_extension,
         Kind::axisymmetric_extension, Kind::poiseuille })
  {
    const Vector3 x(0.5, -1, 2);
    const Vector3 scaled = at(dimensionless(flow(kind), length, velocity), x / length);
    EXPECT_LT((velocity * scaled - at(flow(kind), x)).norm(), 1e-12);
  }
}

}
}
