#include "solver/Errors.h"
#include "solver/mesh/MeshIntegrals.h"
#include "tests/solver/support/SmallMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vesicle::test
{

TEST(MeshIntegrals, CubeIsExact)
{
  const Vector3 at(0.5, -3, 2);
  const TriangleMesh mesh = moved(cube(), at);
  EXPECT_DOUBLE_EQ(flat_area(mesh), 24);
  EXPECT_DOUBLE_EQ(flat_volume(mesh), 8);
  EXPECT_NEAR((volume_centroid(mesh) - at).norm(), 0, 1e-15);
  EXPECT_DOUBLE_EQ(reduced_volume(flat_area(mesh), flat_volume(mesh)),
    48 * std::sqrt(std::numbers::pi) / std::pow(24, 1.5));
}

// Coordinates 10⁶ from the origin are rounded to 10⁻¹⁰; that much and no more is lost.
TEST(MeshIntegrals, LoseNoDigitsFarAway)
{
  const TriangleMesh near = sphere(8);
  const Vector3 by(1e6, -1e6, 1e6);
  const TriangleMesh far = moved(near, by);
  EXPECT_NEAR(flat_volume(far), flat_volume(near), 1e-9);
  EXPECT_NEAR(flat_area(far), flat_area(near), 1e-9);
  EXPECT_NEAR((volume_centroid(far) - by).norm(), 0, 1e-9);
}

TEST(MeshIntegrals, SphereConvergesWithH2)
{
  const auto defect = [](int n) { return 4 * std::numbers::pi / 3 - flat_volume(sphere(n)); };
  EXPECT_NEAR(defect(8) / defect(16), 4, 0.1);
}

TEST(MeshIntegrals, ReducedVolumeOfASphereIsOne)
{
  const double radius = 3e-6;
  EXPECT_NEAR(reduced_volume(4 * std::numbers::pi * radius * radius,
                4 * std::numbers::pi / 3 * std::pow(radius, 3)),
    1, 1e-14);
  EXPECT_THROW(reduced_volume(0, 0), InputError);
}

TEST(MeshIntegrals, NoCentroidWithoutVolume)
{
  const TriangleMesh sheet{ sphere(1).points.topRows(3), triangle_list({ { 0, 1, 2 } }) };
  EXPECT_THROW(volume_centroid(sheet), InputError);
  EXPECT_THROW(volume_centroid({ Points(0, 3), Triangles(0, 3) }), InputError);
}

}
