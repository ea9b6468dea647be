#include "solver/mesh/Topology.h"
#include "tests/solver/support/SmallMeshes.h"

#include <gtest/gtest.h>

namespace vesicle::test
{

namespace
{
void expect_same(const Topology& l, const Topology& r)
{
  EXPECT_EQ(l.closed, r.closed);
  EXPECT_EQ(l.manifold, r.manifold);
  EXPECT_EQ(l.oriented, r.oriented);
  EXPECT_EQ(l.components, r.components);
  EXPECT_EQ(l.genus, r.genus);
}
}

TEST(Topology, KnownSurfaces)
{
  expect_same(topology(sphere()), { true, true, true, 1, 0 });
  expect_same(topology(torus()), { true, true, true, 1, 1 });
  const TriangleMesh pair = together(torus(), moved(sphere(), Vector3(9, 0, 0)));
  expect_same(topology(pair), { true, true, true, 2, 1 });
  expect_same(topology(without_triangles(sphere(), { 7 })), { false, true, true, 1, {} });
  expect_same(topology(bow_tie()), { true, false, true, 1, {} });
  expect_same(topology(turned_over(sphere(), 3, 9)), { true, true, false, 1, {} });
  EXPECT_FALSE(topology(projective_plane()).oriented);
  expect_same(topology({ Points(0, 3), Triangles(0, 3) }), { false, true, true, 0, {} });
}

TEST(Topology, AWallInsideIsNoManifold)
{
  TriangleMesh mesh = sphere(1);
  mesh.triangles.conservativeResize(21, 3);
  mesh.triangles.row(20) << mesh.triangles(0, 0), mesh.triangles(0, 1), 3;
  EXPECT_FALSE(topology(mesh).manifold);
}

TEST(Topology, DoesNotDependOnTheNumbering)
{
  for (const TriangleMesh& mesh : { sphere(), torus(), bow_tie(), turned_over(torus(), 0, 40),
         without_triangles(torus(), { 3, 90 }), projective_plane() })
    expect_same(topology(mesh), topology(in_reverse_order(mesh)));
}

}
