#include "solver/dynamics/Projection.h"
#include "solver/mesh/MeshIntegrals.h"
#include "solver/mesh/shapes/GeodesicSphere.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

namespace vesicle
{
namespace
{

TEST(Projection, MeetsAreaAndVolumeAtOnceAndReportsWhatItRemoved)
{
  const TriangleMesh mesh = test::mapped(test::jittered_sphere(4, 0.2), test::ellipsoid_2_1_1);
  const SurfaceSpace linear(
    SurfaceBasis::linear, mesh.triangles, static_cast<int>(mesh.points.rows()));
  const double A = flat_area(mesh), V = flat_volume(mesh);
  Points points = mesh.points;
  const ProjectionResult removed =
    project_area_and_volume(points, linear, 1.001 * A, 0.9995 * V, false);
  EXPECT_NEAR(removed.area_removed, 0.001 / 1.001, 1e-12);
  EXPECT_NEAR(removed.volume_removed, 0.0005 / 0.9995, 1e-12);
  EXPECT_NEAR(flat_area({ points, mesh.triangles }) / A, 1.001, 1e-12);
  EXPECT_NEAR(flat_volume({ points, mesh.triangles }) / V, 0.9995, 1e-12);
}

// No shape has the area of a smaller ball than its volume: what is left is reported, not hidden.
TEST(Projection, SaysWhatItCanNotRemove)
{
  const TriangleMesh mesh = test::mapped(test::smooth_sphere(320), test::ellipsoid_2_1_1);
  const SurfaceSpace linear(
    SurfaceBasis::linear, mesh.triangles, static_cast<int>(mesh.points.rows()));
  const double A = flat_area(mesh), V = flat_volume(mesh);
  Points points = mesh.points;
  EXPECT_LE(project_area_and_volume(points, linear, 1.001 * A, V, false).left, 1e-13);
  points = mesh.points;
  EXPECT_FALSE(project_area_and_volume(points, linear, 0.3 * A, V, false).left < 1e-3);
}

TEST(Projection, OnALimitSurface)
{
  const TriangleMesh mesh = test::mapped(test::smooth_sphere(320), test::ellipsoid_2_1_1);
  const SurfaceSpace loop(SurfaceBasis::loop, mesh.triangles, static_cast<int>(mesh.points.rows()));
  const AreaAndVolume before(loop, mesh.points);
  Points points = mesh.points;
  project_area_and_volume(points, loop, 1.001 * before.area(), 0.9995 * before.volume(), false);
  const AreaAndVolume after(loop, points);
  EXPECT_NEAR(after.area() / before.area(), 1.001, 1e-12);
  EXPECT_NEAR(after.volume() / before.volume(), 0.9995, 1e-12);
}

TEST(Projection, OnASphereOnlyTheVolumeIsSet)
{
  const TriangleMesh mesh = geodesic_sphere(4);
  const SurfaceSpace linear(
    SurfaceBasis::linear, mesh.triangles, static_cast<int>(mesh.points.rows()));
  Points points = mesh.points;
  project_area_and_volume(points, linear, 0, 1.01 * flat_volume(mesh), true);
  EXPECT_NEAR(flat_volume({ points, mesh.triangles }) / flat_volume(mesh), 1.01, 1e-12);
}

}
}
