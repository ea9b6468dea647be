// Meshes spoiled at a known place.

#include "apps/GuiltyTriangles.h"
#include "solver/mesh/shapes/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <limits>

namespace vesicle
{
namespace
{

bool has_corner(const TriangleMesh& mesh, int triangle, int vertex)
{
  return (mesh.triangles.row(triangle).array() == vertex).any();
}

}

TEST(GuiltyTriangles, AreAroundAVertexThatMovedBesideTheOthers)
{
  const TriangleMesh before = geodesic_sphere(4);
  TriangleMesh mesh = before;
  mesh.points.rowwise() += Eigen::RowVector3d(5, 0, 0); // that all move tells nothing
  mesh.points.row(7) *= 1.05;
  const GuiltyTriangles guilty = guilty_triangles(mesh, before);
  ASSERT_GE(guilty.triangles.size(), 5U);
  for (const int t : guilty.triangles)
    EXPECT_TRUE(has_corner(mesh, t, 7));
  EXPECT_NE(guilty.why.find("vertex 7"), std::string::npos) << guilty.why;
  EXPECT_LT((guilty.place - mesh.points.row(7).transpose()).norm(), 0.5);
}

TEST(GuiltyTriangles, PassThroughEachOther)
{
  const TriangleMesh before = geodesic_sphere(4);
  TriangleMesh mesh = before;
  mesh.points.row(7) *= -1.2; // out through the other side
  const GuiltyTriangles guilty = guilty_triangles(mesh, before);
  ASSERT_EQ(guilty.triangles.size(), 2U);
  EXPECT_NE(guilty.why.find("cross"), std::string::npos) << guilty.why;
  EXPECT_TRUE(has_corner(mesh, guilty.triangles[0], 7) || has_corner(mesh, guilty.triangles[1], 7));
}

TEST(GuiltyTriangles, AreThinOrNotFinite)
{
  TriangleMesh mesh = geodesic_sphere(4);
  const int a = mesh.triangles(9, 0), b = mesh.triangles(9, 1);
  mesh.points.row(a) = mesh.points.row(b) + 0.02 * (mesh.points.row(a) - mesh.points.row(b));
  const GuiltyTriangles thin = guilty_triangles(mesh, mesh);
  ASSERT_FALSE(thin.triangles.empty());
  EXPECT_NE(thin.why.find("degrees"), std::string::npos) << thin.why;
  for (const int t : thin.triangles)
    EXPECT_TRUE(has_corner(mesh, t, a) || has_corner(mesh, t, b));

  mesh.points(3, 1) = std::numeric_limits<double>::quiet_NaN();
  const GuiltyTriangles lost = guilty_triangles(mesh, mesh);
  EXPECT_EQ(lost.why, "positions are not finite");
  for (const int t : lost.triangles)
    EXPECT_TRUE(has_corner(mesh, t, 3));
}

TEST(GuiltyTriangles, OfAGoodMeshAreWhereItsEnergyIsKnownWorst)
{
  const TriangleMesh mesh = geodesic_sphere(4);
  const GuiltyTriangles guilty = guilty_triangles(mesh, mesh);
  EXPECT_EQ(guilty.triangles.size(), 1U);
  EXPECT_NE(guilty.why.find("known to"), std::string::npos);
}

}
