#include "solver/mesh/shapes/GeodesicSphere.h"

#include "solver/Errors.h"
#include "solver/mesh/MeshIntegrals.h"
#include "solver/mesh/MeshQuality.h"
#include "solver/mesh/Topology.h"

#include <gtest/gtest.h>

namespace vesicle::test
{

TEST(GeodesicSphere, CountsRadiusAndUniformity)
{
  for (const int n : { 1, 2, 3, 4, 8, 16 })
  {
    const TriangleMesh mesh = geodesic_sphere(n);
    EXPECT_EQ(mesh.triangles.rows(), 20 * n * n);
    EXPECT_EQ(mesh.points.rows(), 10 * n * n + 2);
    EXPECT_LT((mesh.points.rowwise().norm().array() - 1).abs().maxCoeff(), 1e-15);
    EXPECT_GT(flat_volume(mesh), 0);
    const Topology t = topology(mesh);
    EXPECT_TRUE(t.closed && t.manifold && t.oriented && t.components == 1 && t.genus == 0);
    // Projection shrinks the edges near the icosahedron's corners: measured ratios 1.28, 1.38, 1.43
    // and 1.47 at n = 4, 8, 16 and 64.
    EXPECT_LT(mesh_quality(mesh).edge_ratio, 1.45);
  }
  EXPECT_THROW(geodesic_sphere(0), InputError);
}

TEST(GeodesicSphere, NearestFrequency)
{
  EXPECT_EQ(geodesic_frequency(320), 4);
  EXPECT_EQ(geodesic_frequency(1280), 8);
  EXPECT_EQ(geodesic_frequency(5120), 16);
  EXPECT_EQ(geodesic_frequency(20480), 32);
  EXPECT_EQ(geodesic_frequency(0), 1);
  EXPECT_EQ(geodesic_frequency(409), 4); // 320 and 500
  EXPECT_EQ(geodesic_frequency(411), 5);
}

}
