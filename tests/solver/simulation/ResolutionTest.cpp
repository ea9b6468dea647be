#include "solver/simulation/Resolution.h"

#include "tests/solver/support/TestMeshes.h"

#include <gmock/gmock.h>

#include <cstdio>

namespace vesicle
{
namespace
{

std::string complaint(const TriangleMesh& mesh)
{
  return Resolution(mesh.triangles, static_cast<int>(mesh.points.rows()))
    .complaint(mesh.points, 0.01);
}

TEST(Resolution, SaysNothingWhereTheShapeIsHeld)
{
  for (const int triangles : { 320, 1280 })
    EXPECT_EQ(complaint(test::mapped(test::smooth_sphere(triangles), test::ellipsoid_2_1_1)), "");
}

// A disc thinner than its triangles are long: its rim, a circle of radius 3 about z, is lost.
TEST(Resolution, NamesThePlaceAndTheNumber)
{
  const auto disc = [](const Vector3& n) { return Vector3(3 * n.x(), 3 * n.y(), 0.15 * n.z()); };
  const std::string text = complaint(test::mapped(test::smooth_sphere(320), disc));
  EXPECT_THAT(text, testing::StartsWith("320 triangles don't hold the shape"));
  double x = 0, y = 0, z = 0, triangles = 0;
  ASSERT_EQ(std::sscanf(text.c_str() + text.find("near ("),
              "near (%lf, %lf, %lf). It needs about %lf", &x, &y, &z, &triangles),
    4)
    << text;
  EXPECT_GT(std::hypot(x, y), 2);
  EXPECT_GT(triangles, 450);
}

}
}
