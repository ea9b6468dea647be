#include "solver/surface/VertexClusters.h"

#include "solver/mesh/shapes/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <set>

namespace vesicle::test
{

TEST(VertexClusters, EachVertexIsInOneNearItsFirstVertex)
{
  const TriangleMesh mesh = geodesic_sphere(12);
  const int n = static_cast<int>(mesh.points.rows());
  const Connectivity connectivity(mesh.triangles, n);
  for (const double radius : { 0.01, 0.3, 9. })
  {
    const VertexClusters clusters(mesh.points, connectivity.vertex_neighbours, radius);
    std::set<int> seen;
    for (int c = 0; c < clusters.size(); ++c)
    {
      ASSERT_FALSE(clusters[c].empty());
      EXPECT_LE(clusters[c].size(), 256U);
      for (const int i : clusters[c])
      {
        EXPECT_TRUE(seen.insert(i).second) << i;
        EXPECT_LE((mesh.points.row(i) - mesh.points.row(clusters[c].front())).norm(), radius);
      }
    }
    EXPECT_EQ(static_cast<int>(seen.size()), n);
    EXPECT_EQ(clusters.size() == n, radius < 0.1);
  }
}

// Two leaves a hair's breadth apart don't touch.
TEST(VertexClusters, AreConnected)
{
  TriangleMesh leaves{ Points(6, 3), Triangles(2, 3) };
  leaves.points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1e-3, 1, 0, 1e-3, 0, 1, 1e-3;
  leaves.triangles << 0, 1, 2, 3, 4, 5;
  const Connectivity connectivity(leaves.triangles, 6);
  const VertexClusters clusters(leaves.points, connectivity.vertex_neighbours, 3);
  ASSERT_EQ(clusters.size(), 2);
  EXPECT_EQ(clusters[0].size(), 3U);
}

}
