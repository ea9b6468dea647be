#include "solver/mesh/SelfCrossing.h"

#include "solver/mesh/MeshInspection.h"
#include "solver/mesh/shapes/GeodesicSphere.h"
#include "tests/solver/support/SmallMeshes.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace vesicle::test
{
namespace
{

/// A tip of the sphere pushed by `depth` along −z.
TriangleMesh dented(double depth)
{
  TriangleMesh mesh = geodesic_sphere(16);
  for (int i = 0; i < mesh.points.rows(); ++i)
  {
    const double distance = (mesh.points.row(i) - Eigen::RowVector3d(0, 0, 1)).squaredNorm();
    mesh.points(i, 2) -= depth * std::exp(-distance / 0.15);
  }
  return mesh;
}

}

TEST(SelfCrossing, IsFoundWithItsPlace)
{
  const TriangleMesh mesh = dented(2.6); // its tip goes exactly through a corner
  const auto crossing = find_self_crossing(mesh);
  ASSERT_TRUE(crossing);
  EXPECT_LT(crossing->first, crossing->second);
  for (const int t : { crossing->first, crossing->second })
  {
    const auto [a, b, c] = corners(mesh, t, crossing->place);
    const Vector3 normal = (b - a).cross(c - a).normalized();
    EXPECT_NEAR(normal.dot(a), 0, 1e-12) << "the place lies in the triangle's plane";
    EXPECT_LT(std::min({ a.norm(), b.norm(), c.norm() }), 0.3);
  }
}

// The dent's tip reaches the other side, at z = −1, at a depth of 2.
TEST(SelfCrossing, BeginsWhereTheSidesMeet)
{
  for (const double depth : { 0., 0.5, 1., 1.9, 1.99 })
    EXPECT_FALSE(find_self_crossing(dented(depth))) << depth;
  for (const double depth : { 2.01, 2.1, 2.3 })
    EXPECT_TRUE(find_self_crossing(dented(depth))) << depth;
}

TEST(SelfCrossing, BodiesThatTouchOrLieApartDont)
{
  EXPECT_FALSE(find_self_crossing(bow_tie()));
  const TriangleMesh ball = geodesic_sphere(6);
  const double touch = ball.points.col(0).maxCoeff() - ball.points.col(0).minCoeff();
  EXPECT_FALSE(find_self_crossing(together(ball, moved(ball, Vector3(touch, 0, 0)))));
  EXPECT_FALSE(find_self_crossing(together(ball, moved(ball, Vector3(1.01 * touch, 0, 0)))));
  EXPECT_TRUE(find_self_crossing(together(ball, moved(ball, Vector3(0.97 * touch, 0.01, 0.02)))));
  EXPECT_FALSE(find_self_crossing(together(ball, ball))) << "the same sheet twice";
}

// Three fans about an edge, folded to an angle that rounding can hardly tell from 0.
TEST(SelfCrossing, NeighboursThatAreNearlyFoldedDont)
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> any(-1, 1);
  for (const double angle : { 0., 1e-16, 1e-12, 1e-8, 1e-4 })
  {
    for (int round = 0; round < 200; ++round)
    {
      TriangleMesh fold{ Points(6, 3),
        triangle_list({ { 0, 1, 2 }, { 1, 0, 3 }, { 0, 2, 4 }, { 0, 3, 5 } }) };
      const double x = any(random), y = any(random);
      fold.points << 0, 0, 0, 1, 0, 0, x, 1, 0, y, 1, angle, any(random), 1.5, -angle, any(random),
        1.5, 3 * angle;
      fold.points.rowwise() += Eigen::RowVector3d(any(random), 1e3 * any(random), 7);
      if (find_self_crossing(fold))
      {
        EXPECT_GE(angle, 1e-8) << "told from rounding only";
      }
      fold.triangles.conservativeResize(2, 3);
      EXPECT_FALSE(find_self_crossing(fold));
    }
  }
}

TEST(SelfCrossing, KnownSurfacesAndFarOnesDont)
{
  for (TriangleMesh mesh :
    { sphere(), torus(), clifford_torus(40, 20), jittered_sphere(8, 0.2), geodesic_sphere(40) })
  {
    EXPECT_FALSE(find_self_crossing(mesh));
    mesh.points.array() += 1e6;
    EXPECT_FALSE(find_self_crossing(mesh));
  }
  EXPECT_FALSE(find_self_crossing({ Points(0, 3), Triangles(0, 3) }));
}

}
