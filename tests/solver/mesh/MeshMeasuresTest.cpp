#include "tests/solver/mesh/TestMeshes.h"

#include "solver/Errors.h"
#include "solver/mesh/MeshIntegrals.h"
#include "solver/mesh/MeshQuality.h"

#include <gtest/gtest.h>

namespace vesicle::test
{

namespace
{
/// The cube of side 2 about the origin, its faces cut along diagonals.
TriangleMesh cube()
{
  TriangleMesh mesh{ Points(8, 3), Triangles(12, 3) };
  for (int i = 0; i < 8; ++i)
  {
    mesh.points.row(i) << (i & 1 ? 1 : -1), (i & 2 ? 1 : -1), (i & 4 ? 1 : -1);
  }
  mesh.triangles = triangle_list({ { 0, 2, 3 }, { 0, 3, 1 }, { 4, 5, 7 }, { 4, 7, 6 }, { 0, 1, 5 },
    { 0, 5, 4 }, { 2, 6, 7 }, { 2, 7, 3 }, { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 }, { 1, 7, 5 } });
  return mesh;
}
}

TEST(MeshMeasures, CubeIsExact)
{
  const Vector3 at(0.5, -3, 2);
  const TriangleMesh mesh = moved(cube(), at);
  EXPECT_DOUBLE_EQ(flat_area(mesh), 24);
  EXPECT_DOUBLE_EQ(flat_volume(mesh), 8);
  EXPECT_NEAR((volume_centroid(mesh) - at).norm(), 0, 1e-15);
  EXPECT_DOUBLE_EQ(reduced_volume(flat_area(mesh), flat_volume(mesh)),
    48 * std::sqrt(std::numbers::pi) / std::pow(24, 1.5));
  const MeshQuality quality = mesh_quality(mesh);
  EXPECT_NEAR(quality.min_angle_deg, 45, 1e-12);
  EXPECT_DOUBLE_EQ(quality.edge_ratio, std::sqrt(2));
  EXPECT_DOUBLE_EQ(quality.min_edge, 2);
  EXPECT_NEAR(quality.mean_edge, (4 + 2 * std::sqrt(2)) / 3, 1e-15);
}

// Coordinates 10⁶ from the origin are rounded to 10⁻¹⁰; that much and no more is lost.
TEST(MeshMeasures, LoseNoDigitsFarAway)
{
  const TriangleMesh near = sphere(8);
  const Vector3 by(1e6, -1e6, 1e6);
  const TriangleMesh far = moved(near, by);
  EXPECT_NEAR(flat_volume(far), flat_volume(near), 1e-9);
  EXPECT_NEAR(flat_area(far), flat_area(near), 1e-9);
  EXPECT_NEAR((volume_centroid(far) - by).norm(), 0, 1e-9);
}

TEST(MeshMeasures, SphereConvergesWithH2)
{
  const auto defect = [](int n) { return 4 * std::numbers::pi / 3 - flat_volume(sphere(n)); };
  EXPECT_NEAR(defect(8) / defect(16), 4, 0.1);
}

TEST(MeshMeasures, ReducedVolumeOfASphereIsOne)
{
  const double radius = 3e-6;
  EXPECT_NEAR(reduced_volume(4 * std::numbers::pi * radius * radius,
                4 * std::numbers::pi / 3 * std::pow(radius, 3)),
    1, 1e-14);
  EXPECT_THROW(reduced_volume(0, 0), InputError);
}

TEST(MeshMeasures, NoCentroidWithoutVolume)
{
  const TriangleMesh sheet{ sphere(1).points.topRows(3), triangle_list({ { 0, 1, 2 } }) };
  EXPECT_THROW(volume_centroid(sheet), InputError);
  EXPECT_THROW(volume_centroid({ Points(0, 3), Triangles(0, 3) }), InputError);
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
