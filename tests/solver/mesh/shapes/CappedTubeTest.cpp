#include "solver/mesh/Connectivity.h"
#include "solver/mesh/Topology.h"
#include "solver/mesh/shapes/CappedTube.h"
#include "solver/mesh/shapes/SphereMesh.h"

#include "tests/solver/support/SmallMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace vesicle::test
{

namespace
{
std::map<int, int> valences(const SphereMesh& mesh)
{
  const int points = static_cast<int>(mesh.directions.rows());
  const Connectivity connectivity(mesh.triangles, points);
  std::map<int, int> count;
  for (int i = 0; i < points; ++i)
    ++count[connectivity.vertex_neighbours.size(i)];
  return count;
}
}

TEST(CappedTube, SmallestOnesAreTheIcosahedronAndTheSixfoldDrum)
{
  const std::vector<CappedTube> twenty = capped_tubes(20), drum = capped_tubes(24);
  ASSERT_EQ(twenty.size(), 1);
  EXPECT_EQ(twenty[0].T(), 1);
  EXPECT_EQ(valences(capped_tube_mesh(twenty[0])), (std::map<int, int>{ { 5, 12 } }));
  ASSERT_EQ(drum.size(), 1);
  EXPECT_EQ(valences(capped_tube_mesh(drum[0])), (std::map<int, int>{ { 5, 12 }, { 6, 2 } }));
  EXPECT_TRUE(capped_tubes(10).empty());
  EXPECT_TRUE(capped_tubes(322).empty()); // neither of 10 nor of 12
}

// Euler: with valences of five and six alone there are twelve fives.
TEST(CappedTube, AllAreClosedWithTwelveFives)
{
  for (const int triangles : { 60, 120, 320, 324, 1260 })
  {
    for (const CappedTube& tube : capped_tubes(triangles))
    {
      SCOPED_TRACE(
        testing::Message() << tube.fold << ": (" << tube.h << ", " << tube.k << "), " << tube.Q);
      EXPECT_EQ(tube.triangles(), triangles);
      const SphereMesh mesh = capped_tube_mesh(tube);
      ASSERT_EQ(mesh.triangles.rows(), triangles);
      ASSERT_EQ(mesh.directions.rows(), triangles / 2 + 2);
      const Topology t = topology({ mesh.directions, mesh.triangles });
      EXPECT_TRUE(t.closed && t.manifold && t.oriented && t.components == 1 && t.genus == 0);
      EXPECT_EQ(valences(mesh)[5], 12);
      EXPECT_EQ(valences(mesh)[6], triangles / 2 - 10);
      EXPECT_EQ(dihedral_symmetries(mesh, tube.fold).size(), 2 * tube.fold - 1);
    }
  }
}

// With T = Q and five sectors every face is the same: the geodesic sphere's number of triangles,
// and on the sphere all face outward.
TEST(CappedTube, EqualFacesAreTheIcosahedrons)
{
  const std::vector<CappedTube> tubes = capped_tubes(320);
  const auto equal =
    std::ranges::find_if(tubes, [](const CappedTube& tube) { return tube.T() == tube.Q; });
  ASSERT_NE(equal, tubes.end());
  const SphereMesh mesh = capped_tube_mesh(*equal);
  EXPECT_LT((mesh.directions.rowwise().norm().array() - 1).abs().maxCoeff(), 1e-15);
  for (const auto& t : mesh.triangles.rowwise())
  {
    const Vector3 a = mesh.directions.row(t[0]), b = mesh.directions.row(t[1]),
                  c = mesh.directions.row(t[2]);
    EXPECT_GT(a.dot(b.cross(c)), 0);
  }
}

}
