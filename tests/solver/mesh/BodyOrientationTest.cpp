#include "solver/mesh/BodyOrientation.h"

#include "solver/mesh/MeshIntegrals.h"
#include "tests/solver/support/SmallMeshes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vesicle::test
{
namespace
{

TriangleMesh inverted(TriangleMesh mesh)
{
  mesh.triangles.col(1).swap(mesh.triangles.col(2));
  return mesh;
}

TriangleMesh scaled(TriangleMesh mesh, double factor)
{
  mesh.points *= factor;
  return mesh;
}

double volume_as_oriented(const TriangleMesh& mesh)
{
  return flat_volume({ mesh.points, BodyOrientation(mesh).triangles });
}

}

TEST(BodyOrientation, ABodyInsideOutIsTurned)
{
  const TriangleMesh mesh = together(sphere(), moved(inverted(sphere()), Vector3(4, 0, 0)));
  const BodyOrientation orientation(mesh);
  ASSERT_EQ(orientation.bodies.size(), 2U);
  EXPECT_EQ(orientation.turned, (std::vector<bool>{ false, true }));
  EXPECT_EQ(orientation.inner_side, (std::vector<bool>{ false, false }));
  EXPECT_NEAR(volume_as_oriented(mesh), 2 * flat_volume(sphere()), 1e-12);
  EXPECT_EQ(to_text(orientation.bodies[1]), "the body about (4, 0, 0) of 320 triangles");
}

TEST(BodyOrientation, TheInnerSideOfAShellStays)
{
  const TriangleMesh shell = together(scaled(sphere(), 2), inverted(sphere()));
  const BodyOrientation orientation(shell);
  EXPECT_FALSE(orientation.any_turned());
  EXPECT_EQ(orientation.inner_side, (std::vector<bool>{ false, true }));
  EXPECT_NEAR(volume_as_oriented(shell), 7 * flat_volume(sphere()), 1e-12);
  EXPECT_NEAR(volume_as_oriented(inverted(shell)), 7 * flat_volume(sphere()), 1e-12)
    << "as a whole inside out";
}

TEST(BodyOrientation, BodiesWithinOthersStayBodies)
{
  const TriangleMesh nested = together(inverted(sphere()), inverted(scaled(sphere(), 3)));
  const BodyOrientation orientation(nested);
  EXPECT_EQ(orientation.bodies[0].within, 1);
  EXPECT_EQ(orientation.inner_side, (std::vector<bool>{ false, false }));
  EXPECT_NEAR(volume_as_oriented(nested), 28 * flat_volume(sphere()), 1e-11);
}

TEST(BodyOrientation, OpenAndInconsistentPartsAreLeftAsTheyAre)
{
  for (const TriangleMesh& mesh :
    { without_triangles(inverted(sphere()), { 3 }), turned_over(sphere(), 3, 9) })
  {
    const BodyOrientation orientation(mesh);
    EXPECT_TRUE(orientation.bodies.empty());
    EXPECT_EQ(orientation.triangles, mesh.triangles);
  }
}

}
