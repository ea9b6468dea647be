#include "solver/mesh/SurfaceDistance.h"

#include "solver/mesh/MeshQuality.h"
#include "solver/mesh/shapes/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vesicle::test
{
namespace
{

TriangleMesh sphere(double radius, int n)
{
  TriangleMesh mesh = geodesic_sphere(n);
  mesh.points *= radius;
  return mesh;
}

/// The rectangle 0 ≤ x ≤ a, 0 ≤ y ≤ 1 at a height.
TriangleMesh rectangle(double a, double z)
{
  TriangleMesh mesh;
  mesh.points.resize(4, 3);
  mesh.points << 0, 0, z, a, 0, z, a, 1, z, 0, 1, z;
  mesh.triangles.resize(2, 3);
  mesh.triangles << 0, 1, 2, 0, 2, 3;
  return mesh;
}

}

TEST(SurfaceDistance, OfParallelPlanesIsTheirDistance)
{
  const SurfaceDistance d = surface_distance(rectangle(2, 0), rectangle(2, 0.25));
  EXPECT_DOUBLE_EQ(d.mean, 0.25);
  EXPECT_DOUBLE_EQ(d.rms, 0.25);
  EXPECT_DOUBLE_EQ(d.largest, 0.25);
}

// Hausdorff's distance is the larger of both ways: of a strip to a part of it nothing, of the part
// to the strip all. Of the strip's points x > 1 the distance is x − 1.
TEST(SurfaceDistance, IsThatOfBothWays)
{
  const SurfaceDistance there = surface_distance(rectangle(1, 0), rectangle(3, 0));
  const SurfaceDistance back = surface_distance(rectangle(3, 0), rectangle(1, 0));
  EXPECT_DOUBLE_EQ(there.largest, 2);
  EXPECT_DOUBLE_EQ(back.largest, 2);
  EXPECT_DOUBLE_EQ(there.place.x(), 3);
  EXPECT_DOUBLE_EQ(there.mean, back.mean);
  EXPECT_GT(there.mean, 0);
}

// Flat triangles of edges h are within h²/(8R)·4/3 or so of their sphere: three times h²/8R bounds
// it.
TEST(SurfaceDistance, OfShellsIsTheDifferenceOfTheirRadii)
{
  double last = 1;
  for (const int n : { 8, 16 })
  {
    const double h = mesh_quality(sphere(1, n)).mean_edge;
    const SurfaceDistance d = surface_distance(sphere(1, n), sphere(1.2, n + 3));
    EXPECT_NEAR(d.mean, 0.2, 3 * h * h / 8);
    EXPECT_NEAR(d.largest, 0.2, 3 * h * h / 8);
    EXPECT_LT(std::abs(d.mean - 0.2), last / 2);
    last = std::abs(d.mean - 0.2);
  }
  EXPECT_LT(surface_distance(sphere(1, 8), sphere(1, 8)).largest, 1e-15);
}

}
