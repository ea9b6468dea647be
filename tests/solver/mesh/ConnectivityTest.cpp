#include "solver/mesh/Connectivity.h"
#include "tests/solver/support/SmallMeshes.h"

#include <gtest/gtest.h>

#include <set>

namespace vesicle::test
{

TEST(Connectivity, CountsOfAClosedSurface)
{
  const TriangleMesh mesh = sphere(3);
  const Connectivity connectivity(mesh.triangles, static_cast<int>(mesh.points.rows()));
  EXPECT_EQ(connectivity.edges.size(), 3u * mesh.triangles.rows() / 2);
  EXPECT_TRUE(std::ranges::all_of(connectivity.edge_triangles, [](int n) { return n == 2; }));
  EXPECT_TRUE(std::ranges::is_sorted(connectivity.edges));
  for (int i = 0; i < mesh.points.rows(); ++i)
    EXPECT_EQ(connectivity.vertex_triangles.size(i), connectivity.vertex_neighbours.size(i));
}

TEST(Connectivity, ListsAreAscendingAndComplete)
{
  const TriangleMesh mesh = without_triangles(torus(), { 5 });
  const int points = static_cast<int>(mesh.points.rows());
  const Connectivity connectivity(mesh.triangles, points);
  std::vector<std::set<int>> triangles(points), neighbours(points);
  for (int t = 0; t < mesh.triangles.rows(); ++t)
  {
    for (const int i : mesh.triangles.row(t))
    {
      triangles[i].insert(t);
      for (const int j : mesh.triangles.row(t))
        if (i != j)
          neighbours[i].insert(j);
    }
  }
  const auto same = [](const AdjacencyList& list, int i, const std::set<int>& expected)
  { return std::equal(list.begin(i), list.end(i), expected.begin(), expected.end()); };
  for (int i = 0; i < points; ++i)
  {
    EXPECT_TRUE(same(connectivity.vertex_triangles, i, triangles[i])) << i;
    EXPECT_TRUE(same(connectivity.vertex_neighbours, i, neighbours[i])) << i;
  }
  EXPECT_EQ(std::ranges::count(connectivity.edge_triangles, 1), 3);
}

TEST(Connectivity, EmptyMeshAndUnusedPoints)
{
  EXPECT_TRUE(Connectivity(Triangles(0, 3), 0).edges.empty());
  const Connectivity lonely(Triangles(0, 3), 2);
  EXPECT_EQ(lonely.vertex_neighbours.size(1), 0);
}

TEST(Connectivity, MeanEdge)
{
  TriangleMesh mesh{ Points(3, 3), Triangles(1, 3) };
  mesh.points << 0, 0, 0, 3, 0, 0, 0, 4, 0;
  mesh.triangles << 0, 1, 2;
  EXPECT_DOUBLE_EQ(mean_edge(mesh.points, Connectivity(mesh.triangles, 3).vertex_neighbours), 4);
}

}
