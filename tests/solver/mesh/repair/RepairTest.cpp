#include "solver/mesh/repair/Repair.h"

#include "solver/Errors.h"
#include "solver/mesh/MeshInspection.h"
#include "solver/mesh/MeshIntegrals.h"
#include "solver/mesh/MeshQuality.h"
#include "solver/mesh/Preparation.h"
#include "solver/mesh/Topology.h"
#include "solver/mesh/repair/Cleaning.h"
#include "solver/mesh/repair/Components.h"
#include "solver/mesh/repair/Holes.h"
#include "solver/mesh/repair/Sheets.h"
#include "solver/mesh/repair/Smoothing.h"
#include "solver/mesh/shapes/GeodesicSphere.h"
#include "tests/solver/support/TestMeshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace vesicle::test
{
namespace
{

constexpr double pi = std::numbers::pi;

/// The unit cube's surface, moved: 12 triangles, outward.
TriangleMesh cube(double x, double y, double z)
{
  TriangleMesh mesh;
  mesh.points.resize(8, 3);
  for (int i = 0; i < 8; ++i)
    mesh.points.row(i) << x + (i & 1), y + (i >> 1 & 1), z + (i >> 2 & 1);
  mesh.triangles.resize(12, 3);
  mesh.triangles << 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6,
    0, 6, 2, 1, 3, 7, 1, 7, 5;
  return mesh;
}

TriangleMesh both(const TriangleMesh& a, const TriangleMesh& b)
{
  TriangleMesh mesh;
  mesh.points.resize(a.points.rows() + b.points.rows(), 3);
  mesh.points << a.points, b.points;
  mesh.triangles.resize(a.triangles.rows() + b.triangles.rows(), 3);
  mesh.triangles << a.triangles, (b.triangles.array() + static_cast<int>(a.points.rows())).matrix();
  return mesh;
}

TriangleMesh turned(TriangleMesh mesh)
{
  mesh.triangles.col(1).swap(mesh.triangles.col(2));
  return mesh;
}

TriangleMesh ball(double radius, const Vector3& centre, int n = 8)
{
  TriangleMesh mesh = geodesic_sphere(n);
  mesh.points = ((mesh.points * radius).rowwise() + centre.transpose()).eval();
  return mesh;
}

TriangleMesh without_first(const TriangleMesh& mesh, int triangles)
{
  return { mesh.points, mesh.triangles.bottomRows(mesh.triangles.rows() - triangles) };
}

/// Corners of each triangle as points of their own, off by up to `noise`.
TriangleMesh torn_apart(const TriangleMesh& mesh, double noise)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> off(-noise / 2, noise / 2);
  TriangleMesh torn;
  torn.points.resize(mesh.triangles.size(), 3);
  torn.triangles.resize(mesh.triangles.rows(), 3);
  for (int i = 0; i < mesh.triangles.size(); ++i)
  {
    torn.points.row(i) = mesh.points.row(mesh.triangles(i / 3, i % 3));
    torn.points.row(i) += Eigen::RowVector3d(off(random), off(random), off(random));
    torn.triangles(i / 3, i % 3) = i;
  }
  return torn;
}

Repaired repaired(const TriangleMesh& mesh, const RepairSettings& settings = {})
{
  return repair(mesh, settings, "mesh");
}

}

// Cubes that share a point, an edge and a face, once their points are merged.
class Touching : public testing::TestWithParam<std::tuple<Vector3, int, bool>>
{
};

TEST_P(Touching, CubesPart)
{
  const auto& [place, shared, one_turned] = GetParam();
  const TriangleMesh second = cube(place.x(), place.y(), place.z());
  TriangleMesh mesh = both(cube(0, 0, 0), one_turned ? turned(second) : second);
  merge_points(mesh, 1e-6);
  ASSERT_EQ(mesh.points.rows(), 16 - shared);
  EXPECT_FALSE(topology(mesh).manifold);
  EXPECT_EQ(part_sheets(mesh), shared);
  const Topology parted = topology(mesh);
  EXPECT_TRUE(parted.closed);
  EXPECT_TRUE(parted.manifold);
  EXPECT_TRUE(parted.oriented);
  EXPECT_EQ(parted.components, 2);
  EXPECT_EQ(mesh.points.rows(), 16);
  for (const Component& component : components_of(mesh))
  {
    const TriangleMesh body = part_of(mesh, component.triangles);
    EXPECT_EQ(body.triangles.rows(), 12);
    // Corners are drawn back by a tenth of their way to their neighbours, so by less than 0.1 along
    // each axis: the cube smaller by so much on all sides is within.
    EXPECT_GT(std::abs(flat_volume(body)), 0.8 * 0.8 * 0.8);
    EXPECT_LT(std::abs(flat_volume(body)), 1);
  }
}

INSTANTIATE_TEST_SUITE_P(Sheets, Touching,
  testing::Values(std::tuple(Vector3(1, 1, 1), 1, false), std::tuple(Vector3(1, 1, 1), 1, true),
    std::tuple(Vector3(1, 0, 1), 2, false), std::tuple(Vector3(0, 1, -1), 2, false),
    std::tuple(Vector3(1, 0, 1), 2, true), std::tuple(Vector3(1, 0, 0), 4, false),
    std::tuple(Vector3(0, 0, 1), 4, false)));

// Two cubes along an edge, joined elsewhere by a third one and a fourth: one body that touches
// itself. Which triangles belong together at the edge only their facing tells.
TEST(Sheets, ABodyThatTouchesItselfAlongAnEdgeIsPartedThere)
{
  // Voxels about the edge x = 1, y = 1: (0,0) and (1,1) at z = 0, all four at z = 1.
  const std::vector<std::array<int, 3>> voxels{ { 0, 0, 0 }, { 1, 1, 0 }, { 0, 0, 1 }, { 1, 1, 1 },
    { 1, 0, 1 }, { 0, 1, 1 } };
  const auto there = [&](int x, int y, int z) {
    return std::ranges::find(voxels, std::array{ x, y, z }) != voxels.end();
  };
  TriangleMesh mesh;
  for (const auto& [x, y, z] : voxels)
  {
    TriangleMesh voxel = cube(x, y, z);
    const std::array faces{ there(x, y, z - 1), there(x, y, z + 1), there(x, y - 1, z),
      there(x, y + 1, z), there(x - 1, y, z), there(x + 1, y, z) };
    std::vector<bool> kept;
    for (int t = 0; t < 12; ++t)
      kept.push_back(!faces[t / 2]);
    keep_triangles(voxel, kept);
    mesh = both(mesh, voxel);
  }
  for (const bool inward : { false, true })
  {
    TriangleMesh body = inward ? turned(mesh) : mesh;
    merge_points(body, 1e-6);
    drop_unused_points(body);
    ASSERT_FALSE(topology(body).manifold);
    // The edge's lower end; its upper one is where the fan of the sheets is one.
    EXPECT_EQ(part_sheets(body), 1);
    const Topology parted = topology(body);
    EXPECT_TRUE(parted.closed && parted.manifold && parted.oriented);
    EXPECT_EQ(parted.components, 1);
    EXPECT_EQ(parted.genus, 0);
  }
}

TEST(Holes, AreMeasuredAndFilled)
{
  TriangleMesh sphere = geodesic_sphere(8);
  std::vector<bool> kept;
  for (int t = 0; t < sphere.triangles.rows(); ++t)
  {
    const auto [a, b, c] = corners(sphere, t);
    kept.push_back((a + b + c).z() / 3 < std::cos(0.4));
  }
  keep_triangles(sphere, kept);
  drop_unused_points(sphere);
  const auto holes = holes_of(sphere);
  ASSERT_EQ(holes.size(), 1u);
  // The border zigzags around the circle of angle 0.4, within an edge of 0.14 of it.
  EXPECT_NEAR(holes[0].size, std::sin(0.4), 0.15);
  EXPECT_EQ(fill_holes(sphere, 0.2), 0);
  EXPECT_EQ(fill_holes(sphere, 0.6), 1);
  const Topology filled = topology(sphere);
  EXPECT_TRUE(filled.closed && filled.manifold && filled.oriented);
  EXPECT_EQ(filled.genus, 0);
  // Without the cap, whose volume is π h²(3 − h)/3, h = 1 − cos; a border that lies within an edge
  // of the circle takes no more than the cap there.
  const double h = 1 - std::cos(0.4 + 0.14);
  const double cap = pi * h * h * (3 - h) / 3;
  const double whole = flat_volume(geodesic_sphere(8));
  EXPECT_LT(flat_volume(sphere), whole);
  EXPECT_GT(flat_volume(sphere), whole - cap);
}

TEST(Holes, OneOfATriangleIsFilledByIt)
{
  const TriangleMesh sphere = geodesic_sphere(4);
  TriangleMesh open = without_first(sphere, 1);
  EXPECT_EQ(fill_holes(open, 0.5), 1);
  EXPECT_EQ(open.points.rows(), sphere.points.rows());
  EXPECT_EQ(flat_volume(open), flat_volume(open));
  EXPECT_NEAR(flat_volume(open), flat_volume(sphere), 1e-14);
}

// A pass multiplies a mode whose points' neighbours' means are off by −k of it by (1 − λk)(1 − μk):
// on the sphere itself k = h²/2 for edges h, since Δ_s x = −2 x, a mean is h²/4 Δ_s x away, and
// that is nearly 1.
TEST(Smoothing, TakesNoiseAndKeepsTheSphere)
{
  const TriangleMesh sphere = geodesic_sphere(16);
  TriangleMesh noisy = sphere;
  std::mt19937 random(1);
  constexpr double sigma = 0.01;
  std::normal_distribution<double> noise(0, sigma);
  for (auto x : noisy.points.rowwise())
    x *= 1 + noise(random);
  const auto roughness = [](const TriangleMesh& mesh)
  {
    const Eigen::ArrayXd r = mesh.points.rowwise().norm();
    return std::sqrt((r - r.mean()).square().mean());
  };
  TriangleMesh smooth = noisy;
  constexpr int passes = 20;
  smooth_noise(smooth, passes);
  EXPECT_LT(roughness(smooth), roughness(noisy) / 3);
  const double h = mesh_quality(sphere).mean_edge, k = h * h / 2;
  const double growth = std::pow((1 - 0.5 * k) * (1 + 0.53 * k), 3 * passes);
  // The mean of the noise, of 2,562 points, is below four of its deviations, σ/√2562.
  EXPECT_NEAR(flat_volume(smooth) / flat_volume(sphere), growth, 3 * 4 * sigma / std::sqrt(2562));
  EXPECT_EQ(smooth.triangles, sphere.triangles);
}

TEST(Repair, ACleanMeshIsLeftAsItIs)
{
  for (const TriangleMesh& mesh : { ball(2, { 1, 2, 3 }), torus(3, 1, 24, 12) })
  {
    const Repaired result = repaired(mesh);
    EXPECT_FALSE(result.report.changed_anything()) << to_text(result.report);
    EXPECT_EQ(result.mesh.points, mesh.points);
    EXPECT_EQ(result.mesh.triangles, mesh.triangles);
  }
}

TEST(Repair, SeamsCloseByThemselves)
{
  const TriangleMesh sphere = geodesic_sphere(8);
  const Repaired result = repaired(torn_apart(sphere, 1e-6));
  EXPECT_EQ(result.mesh.points.rows(), sphere.points.rows());
  EXPECT_EQ(result.mesh.triangles.rows(), sphere.triangles.rows());
  TriangleMesh mesh = result.mesh;
  EXPECT_EQ(prepare_for_dynamics(mesh, "mesh"), "");
  EXPECT_NEAR(*result.report.after.volume, flat_volume(sphere), 1e-5);
  EXPECT_FALSE(result.report.before.volume);
}

TEST(Repair, DoubledTrianglesAndThoseWithoutAreaGo)
{
  const TriangleMesh sphere = geodesic_sphere(4);
  TriangleMesh mesh = sphere;
  mesh.triangles.conservativeResize(sphere.triangles.rows() + 2, 3);
  const auto first = sphere.triangles.row(0).eval();
  mesh.triangles.row(sphere.triangles.rows()) << first[1], first[2], first[0];
  mesh.triangles.row(sphere.triangles.rows() + 1) << first[1], first[1], first[0];
  const Repaired result = repaired(mesh);
  EXPECT_EQ(result.report.doubled_triangles, 1);
  EXPECT_EQ(result.report.triangles_without_area, 1);
  EXPECT_EQ(result.mesh.triangles, sphere.triangles);
}

TEST(Repair, ScrapsGoByAreaOrByTriangles)
{
  const TriangleMesh mesh =
    both(both(ball(1, { 0, 0, 0 }), ball(0.05, { 3, 0, 0 }, 2)), ball(0.5, { -3, 0, 0 }, 2));
  Repaired result = repaired(mesh);
  EXPECT_EQ(result.report.scraps, 1);
  EXPECT_EQ(result.report.scrap_triangles, 80);
  EXPECT_EQ(result.report.after.components, 2);
  RepairSettings settings;
  settings.scrap_triangles = 100;
  EXPECT_EQ(repaired(mesh, settings).report.after.components, 1);
  settings = {};
  settings.scrap_share = 0;
  EXPECT_EQ(repaired(mesh, settings).report.after.components, 3);
  settings.largest_only = true;
  result = repaired(mesh, settings);
  EXPECT_EQ(result.report.scraps, 2);
  EXPECT_EQ(result.mesh.triangles, geodesic_sphere(8).triangles);
}

TEST(Repair, BodiesFaceOutwardAndShellsKeepTheirInside)
{
  TriangleMesh mixed = ball(1, { 0, 0, 0 });
  for (int t = 0; t < 100; ++t)
    std::swap(mixed.triangles(5 * t, 1), mixed.triangles(5 * t, 2));
  const TriangleMesh inside = turned(ball(0.5, { 0, 0, 0 }, 4));
  const TriangleMesh mesh = both(both(mixed, inside), turned(ball(1, { 3, 0, 0 }, 4)));
  const Repaired result = repaired(mesh);
  EXPECT_TRUE(topology(result.mesh).oriented);
  EXPECT_EQ(result.report.turned_triangles, 100 + 320);
  const double expected = flat_volume(ball(1, { 0, 0, 0 })) -
    flat_volume(ball(0.5, { 0, 0, 0 }, 4)) + flat_volume(ball(1, { 3, 0, 0 }, 4));
  EXPECT_NEAR(*result.report.after.volume, expected, 1e-12);
}

TEST(Repair, LargeHolesAreLeftAndTold)
{
  const TriangleMesh sphere = geodesic_sphere(8);
  std::vector<bool> kept;
  for (int t = 0; t < sphere.triangles.rows(); ++t)
  {
    const auto [a, b, c] = corners(sphere, t);
    kept.push_back((a + b + c).z() < 0);
  }
  TriangleMesh half = sphere;
  keep_triangles(half, kept);
  const Repaired result = repaired(half);
  EXPECT_EQ(result.report.open_holes, 1);
  EXPECT_EQ(result.report.filled_holes, 0);
  EXPECT_FALSE(result.report.after.volume);
  EXPECT_THAT(to_text(result.report), testing::HasSubstr("1 hole is left open"));
}

TEST(Repair, EachBodyIsResampled)
{
  RepairSettings settings;
  settings.triangles = 320;
  const TriangleMesh mesh = both(ball(1, { 0, 0, 0 }), turned(ball(0.5, { 0, 0, 0 })));
  const Repaired result = repaired(mesh, settings);
  EXPECT_EQ(result.report.resampled.size(), 2u);
  EXPECT_EQ(result.mesh.triangles.rows(), 640);
  // Flat triangles of 320 lose a few percent of the smooth volume, here 4/3 π (1 − 1/8).
  EXPECT_NEAR(flat_volume(result.mesh), 4. / 3 * pi * (1 - 1. / 8), 0.03 * 4. / 3 * pi);
}

TEST(Repair, OneSidedSurfacesAreRefusedWithThePlace)
{
  constexpr int n = 24; // Möbius' strip
  TriangleMesh strip;
  strip.points.resize(2 * n, 3);
  for (int i = 0; i < n; ++i)
    for (const int side : { 0, 1 })
    {
      const double angle = 2 * pi * i / n, width = side == 0 ? -0.3 : 0.3;
      const double r = 1 + width * std::cos(angle / 2);
      strip.points.row(2 * i + side) << r * std::cos(angle), r * std::sin(angle),
        width * std::sin(angle / 2);
    }
  strip.triangles.resize(2 * n, 3);
  for (int i = 0; i < n; ++i)
  {
    const bool last = i == n - 1;
    const int a = 2 * i, b = a + 1, c = last ? 1 : a + 2, d = last ? 0 : a + 3;
    strip.triangles.row(2 * i) << a, b, c;
    strip.triangles.row(2 * i + 1) << b, d, c;
  }
  try
  {
    repair(strip, {}, "strip.off");
    FAIL() << "accepted";
  }
  catch (const InputError& error)
  {
    EXPECT_THAT(error.what(), testing::HasSubstr("strip.off: the surface has one side only"));
    EXPECT_THAT(error.what(), testing::HasSubstr("near ("));
  }
}

}
