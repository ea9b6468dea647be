#include "solver/mesh/MeshQuality.h"

#include "tests/solver/support/SmallMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace vesicle::test
{

TEST(MeshQuality, CubeIsExact)
{
  const MeshQuality quality = mesh_quality(cube());
  EXPECT_NEAR(quality.min_angle_deg, 45, 1e-12);
  EXPECT_DOUBLE_EQ(quality.edge_ratio, std::sqrt(2));
  EXPECT_DOUBLE_EQ(quality.min_edge, 2);
  EXPECT_NEAR(quality.mean_edge, (4 + 2 * std::sqrt(2)) / 3, 1e-15);
}

TEST(MeshQuality, FindsTheWorstTriangle)
{
  TriangleMesh mesh = sphere();
  const Eigen::RowVector3i corners = mesh.triangles.row(33);
  mesh.points.row(corners[0]) = 0.49 * mesh.points.row(corners[1]) +
    0.49 * mesh.points.row(corners[2]) + 0.02 * mesh.points.row(corners[0]);
  const MeshQuality quality = mesh_quality(mesh);
  EXPECT_EQ(quality.worst_triangle, 33);
  EXPECT_LT(quality.min_angle_deg, 5);
  mesh.points.row(corners[0]) = mesh.points.row(corners[1]);
  EXPECT_EQ(mesh_quality(mesh).edge_ratio, std::numeric_limits<double>::infinity());
  EXPECT_EQ(mesh_quality(mesh).min_angle_deg, 0);
  EXPECT_EQ(mesh_quality({ Points(0, 3), Triangles(0, 3) }).worst_triangle, -1);
}

}
