#include "solver/Errors.h"
#include "solver/mesh/MeshIntegrals.h"
#include "solver/mesh/Preparation.h"
#include "solver/mesh/remesh/Remesh.h"
#include "solver/mesh/shapes/GeodesicSphere.h"
#include "solver/surface/SurfaceMeasures.h"
#include "solver/mesh/shapes/SampleMeshes.h"
#include "solver/mesh/shapes/ShapeFamily.h"
#include "tests/solver/support/SmallMeshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <numbers>
#include <random>

namespace vesicle::test
{

using testing::HasSubstr;

namespace
{
SphericalParametrisation ellipsoid(double a, double b, double c)
{
  return [=](const Vector3& d) -> Vector3 { return { a * d.x(), b * d.y(), c * d.z() }; };
}

SphericalParametrisation discocyte(double deflation = 0)
{
  ShapeRequest request;
  request.kind = ShapeRequest::Kind::discocyte;
  return shape_family(request).surface(deflation);
}

// Ellipsoids of revolution: c/a for a reduced volume of 0.5 (prolate), 0.4 (both) and 0.35.
constexpr double prolate_05 = 8.0873, prolate_04 = 12.7903, oblate_04 = 0.15475,
                 oblate_035 = 0.13279;

/// A spherical shell between the radii 0.75 and 1.1, open within 0.5 rad
/// of the z axis, the rim rounded: the outline by arc length from the inner pole to the outer one.
Vector3 cup(const Vector3& d)
{
  const double inner = 0.75, outer = 1.1, opening = 0.5;
  const double rim = (outer - inner) / 2, middle = (outer + inner) / 2, pi = std::numbers::pi;
  const double first = inner * (pi - opening), second = pi * rim, third = outer * (pi - opening);
  const double s = std::acos(std::clamp(d.z(), -1.0, 1.0)) / pi * (first + second + third);
  Eigen::Vector2d x; // distance from the axis, height
  const auto polar = [](double r, double angle)
  { return Eigen::Vector2d(r * std::sin(angle), r * std::cos(angle)); };
  if (s < first)
  {
    x = polar(inner, pi - s / inner);
  }
  else if (s < first + second)
  {
    const double turn = (s - first) / rim;
    x = polar(middle, opening) - rim * std::cos(turn) * polar(1, opening) -
      rim * std::sin(turn) * polar(1, opening + pi / 2);
  }
  else
  {
    x = polar(outer, opening + (s - first - second) / outer);
  }
  const double rho = std::hypot(d.x(), d.y());
  return rho < 1e-12 ? Vector3(0, 0, x[1]) : Vector3(x[0] * d.x() / rho, x[0] * d.y() / rho, x[1]);
}

/// Meridians and parallels: long thin triangles around the poles.
TriangleMesh meridians(int rings, int sectors, const SphericalParametrisation& image)
{
  TriangleMesh mesh{ Points(2 + (rings - 1) * sectors, 3),
    Triangles(2 * (rings - 1) * sectors, 3) };
  mesh.points.row(0) = image({ 0, 0, 1 });
  mesh.points.row(1) = image({ 0, 0, -1 });
  const auto id = [&](int i, int j) {
    return i == 0 ? 0 : i == rings ? 1 : 2 + (i - 1) * sectors + j % sectors;
  };
  int t = 0;
  for (int j = 0; j < sectors; ++j)
  {
    for (int i = 0; i < rings; ++i)
    {
      const double theta = std::numbers::pi * i / rings, phi = 2 * std::numbers::pi * j / sectors;
      if (i > 0)
      {
        mesh.points.row(id(i, j)) = image(
          { std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta) });
        mesh.triangles.row(t++) << id(i, j), id(i + 1, j), id(i, j + 1);
      }
      if (i + 1 < rings)
        mesh.triangles.row(t++) << id(i, j + 1), id(i + 1, j), id(i + 1, j + 1);
    }
  }
  return mesh;
}

/// A geodesic sphere with its points thrown about by a quarter of an edge.
TriangleMesh jittered(int n, const SphericalParametrisation& image)
{
  TriangleMesh mesh = geodesic_sphere(n);
  const double size = 0.25 * mesh_quality(mesh).mean_edge;
  std::mt19937 generator(1);
  const auto noise = [&] { return size * (generator() / 2147483648.0 - 1); };
  for (int i = 0; i < mesh.points.rows(); ++i)
  {
    const double x = noise(), y = noise(), z = noise();
    const Vector3 moved = mesh.points.row(i).transpose() + Vector3(x, y, z);
    mesh.points.row(i) = image(moved.normalized());
  }
  return mesh;
}

/// Of the points to the ellipsoid, to first order, in units of r0.
double distance_to_ellipsoid(const Points& points, const Vector3& axes)
{
  double largest = 0;
  for (const Vector3 x : points.rowwise())
  {
    const Vector3 u = x.cwiseQuotient(axes);
    largest = std::max(largest, std::abs(u.squaredNorm() - 1) / (2 * u.cwiseQuotient(axes).norm()));
  }
  return largest / std::cbrt(axes.prod());
}

void expect_good(const Remeshed& remeshed, int triangles, double least_angle, double edge_ratio)
{
  const RemeshReport& report = remeshed.report;
  TriangleMesh mesh = remeshed.mesh;
  EXPECT_EQ(mesh.triangles.rows(), triangles);
  EXPECT_EQ(report.triangles, triangles);
  EXPECT_EQ(prepare_for_dynamics(mesh, "remeshed"), "");
  EXPECT_EQ(mesh.points, remeshed.mesh.points);
  EXPECT_GE(report.quality.min_angle_deg, least_angle);
  EXPECT_LE(report.quality.edge_ratio, edge_ratio);
  EXPECT_GE(report.least_valence, 4);
  EXPECT_LE(report.largest_valence, 8);
}

std::vector<int> valences(const TriangleMesh& mesh)
{
  std::vector<int> result(mesh.points.rows(), 0);
  for (const int i : mesh.triangles.reshaped())
    ++result[i];
  return result;
}

double share_of_valences_5_to_7(const TriangleMesh& mesh)
{
  const std::vector<int> all = valences(mesh);
  const auto count = std::ranges::count_if(all, [](int n) { return std::abs(n - 6) <= 1; });
  return static_cast<double>(count) / static_cast<double>(all.size());
}

int extraordinary_vertices(const TriangleMesh& mesh)
{
  const std::vector<int> all = valences(mesh);
  return static_cast<int>(std::ranges::count_if(all, [](int n) { return n != 6; }));
}

/// Points projected along the radii onto the ellipsoid 2, 1, 1.
TriangleMesh projected(TriangleMesh mesh)
{
  for (auto x : mesh.points.rowwise())
    x /= std::hypot(x[0] / 2, x[1], x[2]);
  return mesh;
}

/// Of Loop's limit surface.
double bending_energy(const TriangleMesh& mesh)
{
  return surface_measures(SurfaceBasis::loop, mesh).bending_energy;
}

TriangleMesh read_off_or_ply(const std::string& name)
{
  std::ifstream file(std::string(VESICLE_SOURCE_DIR "/data/meshes/") + name);
  std::string line;
  int points = 0, triangles = 0;
  while (std::getline(file, line) && line != "end_header")
  {
    std::sscanf(line.c_str(), "element vertex %d", &points);
    std::sscanf(line.c_str(), "element face %d", &triangles);
    if (std::sscanf(line.c_str(), "%d %d", &points, &triangles) == 2)
      break;
  }
  TriangleMesh mesh{ Points(points, 3), Triangles(triangles, 3) };
  for (int i = 0; i < points; ++i)
    file >> mesh.points(i, 0) >> mesh.points(i, 1) >> mesh.points(i, 2);
  for (int t = 0, corners = 0; t < triangles; ++t)
    file >> corners >> mesh.triangles(t, 0) >> mesh.triangles(t, 1) >> mesh.triangles(t, 2);
  prepare_for_dynamics(mesh, name);
  return mesh;
}

std::string refusal(const TriangleMesh& mesh, int triangles)
{
  try
  {
    remesh(mesh, triangles);
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "";
}

Eigen::Matrix3d some_turn()
{
  return Eigen::AngleAxisd(1.1, Vector3(1, -2, 0.5).normalized()).toRotationMatrix();
}
}

struct Case
{
  std::string name;
  TriangleMesh mesh;
  double angle_320, ratio_320, angle_1280, ratio_1280;
};

// Measured: from 54° and an edge ratio of 1.20 (sphere) to 20.6° and 2.54 (prolate v = 0.4 in 320
// triangles, whose edges are ten times as long as the tips' radius of curvature); in 1280 triangles
// at least 31.7° and at most 2.22. Other compilers and orders of points give other meshes of the
// kind.
TEST(Remesh, QualityOfAllShapesFromAnyTriangles)
{
  const std::vector<Case> cases{
    { "sphere", jittered(16, ellipsoid(1, 1, 1)), 42, 1.8, 43, 1.8 },
    { "ellipsoid", meridians(40, 80, ellipsoid(2, 1, 1)), 39, 1.9, 41, 2 },
    { "prolate 0.5", meridians(60, 40, ellipsoid(1, 1, prolate_05)), 25, 2.3, 28, 2.6 },
    { "prolate 0.4", jittered(20, ellipsoid(1, 1, prolate_04)), 15, 3.2, 28, 2.6 },
    { "oblate 0.4", jittered(20, ellipsoid(1, 1, oblate_04)), 27, 2.5, 30, 2.3 },
    { "oblate 0.35", meridians(60, 60, ellipsoid(1, 1, oblate_035)), 25, 2.5, 30, 2.3 },
    { "discocyte", jittered(20, discocyte()), 37, 2, 40, 2 },
    { "discocyte, needles", meridians(60, 90, discocyte()), 37, 2, 40, 2 },
    { "flat discocyte", jittered(24, discocyte(0.4)), 36, 2.1, 38, 2.1 },
    { "cup", meridians(80, 60, cup), 25, 2.5, 30, 2.2 },
  };
  for (const Case& c : cases)
  {
    SCOPED_TRACE(c.name);
    const Remeshed coarse = remesh(c.mesh, 320), fine = remesh(c.mesh, 1280);
    expect_good(coarse, 320, c.angle_320, c.ratio_320);
    expect_good(fine, 1280, c.angle_1280, c.ratio_1280);
    EXPECT_GE(share_of_valences_5_to_7(coarse.mesh), 0.95);
    EXPECT_GE(share_of_valences_5_to_7(fine.mesh), 0.99);
    // At worst 0.24 (a notch in a rim, oblate v = 0.35, whose thickness is about an edge), 0.08 and
    // 0.014; 0.02 and 0.005 on the sphere.
    EXPECT_LT(coarse.report.max_distance, 0.27);
    EXPECT_LT(coarse.report.rms_distance, 0.08);
    EXPECT_LT(fine.report.max_distance, 0.1);
    EXPECT_LT(fine.report.rms_distance, 0.02);
  }
}

// Vertices on the exact surface up to the input's own error; the flat triangles between them
// converge with h².
TEST(Remesh, ConvergesToTheExactEllipsoid)
{
  const TriangleMesh input = jittered(50, ellipsoid(2, 1, 1));
  const double e = std::sqrt(0.75);
  const double area = 2 * std::numbers::pi * (1 + 2 / e * std::asin(e));
  const double volume = 8 * std::numbers::pi / 3;
  std::vector<double> area_error, volume_error;
  for (const int triangles : { 320, 1280, 5120 })
  {
    const Remeshed remeshed = remesh(input, triangles);
    expect_good(remeshed, triangles, 38, 2.2); // measured: 43°, 2.0
    EXPECT_LT(distance_to_ellipsoid(remeshed.mesh.points, { 2, 1, 1 }), 1e-5); // measured 3e-6
    area_error.push_back(1 - flat_area(remeshed.mesh) / area);
    volume_error.push_back(1 - flat_volume(remeshed.mesh) / volume);
  }
  for (const auto& error : { area_error, volume_error })
  {
    EXPECT_NEAR(error[0] / error[1], 4, 0.5);
    EXPECT_NEAR(error[1] / error[2], 4, 0.5);
  }
  EXPECT_LT(volume_error[2], 3e-3);
}

// With h² also where the surface is dimpled.
TEST(Remesh, FollowsADimpledSurface)
{
  const TriangleMesh input = meridians(120, 180, discocyte());
  const RemeshReport coarse = remesh(input, 320).report;
  const RemeshReport fine = remesh(input, 1280).report;
  EXPECT_GT(coarse.rms_distance / fine.rms_distance, 3);
  EXPECT_LT(std::abs(fine.area_error), 0.01);
  EXPECT_LT(std::abs(fine.volume_error), 0.015);
  EXPECT_NEAR(fine.reduced_volume, fine.input_reduced_volume, 3e-3);
}

// The flat triangles of the coarse input enclose 2.5% less than the ellipsoid.
TEST(Remesh, SmoothsCoarseInputs)
{
  const TriangleMesh input = jittered(5, ellipsoid(2, 1, 1));
  const Remeshed remeshed = remesh(input, 5120);
  expect_good(remeshed, 5120, 30, 2.3);
  EXPECT_LT(distance_to_ellipsoid(remeshed.mesh.points, { 2, 1, 1 }), 8e-3); // measured 4.7e-3
  EXPECT_NEAR(flat_volume(remeshed.mesh), 8 * std::numbers::pi / 3, 0.03);
  EXPECT_GT(remeshed.report.volume_error, 0.01);
}

TEST(Remesh, MeshesOfOtherPrograms)
{
  for (const std::string name : { "capsule.ply", "peanut.off" })
  {
    SCOPED_TRACE(name);
    const TriangleMesh input = read_off_or_ply(name);
    for (const int triangles : { 320, 1280 })
    {
      const Remeshed remeshed = remesh(input, triangles);
      expect_good(remeshed, triangles, 33, 2.1);
      EXPECT_LT(remeshed.report.max_distance, triangles == 320 ? 0.06 : 0.02);
      const double r0 = std::cbrt(3 * flat_volume(input) / (4 * std::numbers::pi));
      EXPECT_LT((volume_centroid(remeshed.mesh) - volume_centroid(input)).norm(), 0.01 * r0);
    }
  }
}

TEST(Remesh, NumbersOfTrianglesToOnePercent)
{
  const TriangleMesh input = jittered(12, ellipsoid(2, 1.3, 1));
  for (const int triangles : { 80, 320, 1280 })
    expect_good(remesh(input, triangles), triangles, 33, 2.1);
  for (const int triangles : { 100, 500, 777, 1000, 1500 })
  {
    const Remeshed remeshed = remesh(input, triangles);
    EXPECT_NEAR(remeshed.report.triangles, triangles, 0.01 * triangles);
    expect_good(remeshed, remeshed.report.triangles, 33, 2.1);
  }
  EXPECT_EQ(remesh(sphere(8), 20).report.triangles, 20);
}

// Twelve is the least that a closed mesh can have. Measured: 12 and 14.
TEST(Remesh, FewExtraordinaryVerticesHoweverFine)
{
  const TriangleMesh rough = delaunay_sphere(jittered_sphere(24, 0.3));
  for (const SphericalParametrisation& image :
    { ellipsoid(1, 1, 1), ellipsoid(2, 1, 1), discocyte() })
  {
    const TriangleMesh input = mapped(rough, image);
    for (const int triangles : { 320, 1280, 5120 })
      EXPECT_LE(extraordinary_vertices(remesh(input, triangles).mesh), 20);
  }
}

// A bud that the coarsest meshes would leave out.
TEST(Remesh, LosesNoBud)
{
  const auto budded = [](const Vector3& d) -> Vector3
  { return (1 + 0.6 * std::exp(-40 * (1 - d.z()))) * d; };
  const Remeshed remeshed = remesh(jittered(32, budded), 1280);
  EXPECT_GE(remeshed.report.quality.min_angle_deg, 33);
  EXPECT_LT(remeshed.report.max_distance, 0.05);
}

// Vertices projected onto the exact ellipsoid, so that the triangulation alone is judged. Measured:
// 9.7e-4, 1.6e-5, 2.0e-6 (a smooth start mesh: 9.2e-4, 1.4e-5, 2.0e-6); direct meshing leaves 8e-4
// at 1,280 and 7e-4 at 5,120.
TEST(Remesh, BendingEnergyConverges)
{
  const TriangleMesh input = mapped(delaunay_sphere(jittered_sphere(32, 0.3)), ellipsoid(2, 1, 1));
  const int n = 4000;
  double exact = 0;
  for (int i = 0; i < n; ++i)
  {
    const double theta = std::numbers::pi * (i + 0.5) / n;
    const double w = std::hypot(2 * std::sin(theta), std::cos(theta));
    exact += std::numbers::pi * std::numbers::pi / n * std::sin(theta) * w *
      std::pow(2 / (w * w * w) + 2 / w, 2);
  }
  std::vector<double> error;
  for (const int triangles : { 320, 1280, 5120 })
  {
    const TriangleMesh mesh = projected(remesh(input, triangles).mesh);
    error.push_back(std::abs(bending_energy(mesh) / exact - 1));
  }
  EXPECT_LT(error[0], 1.2e-3);
  // Of order h²: what vertices with five or seven neighbours cost.
  EXPECT_LT(error[1], 1.5e-4);
  EXPECT_LT(error[2], 4e-5);
}

TEST(Remesh, RoundsAnAngularBody)
{
  // An octahedron: eight triangles, far from smooth.
  TriangleMesh input{ Points(6, 3),
    triangle_list({ { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 },
      { 3, 1, 5 }, { 0, 3, 5 } }) };
  input.points << 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1;
  expect_good(remesh(input, 1280), 1280, 30, 2.5);
}

TEST(Remesh, DenseInput)
{
  const Remeshed remeshed = remesh(jittered(71, discocyte()), 1280); // 100,820 triangles
  expect_good(remeshed, 1280, 34, 2);
  EXPECT_LT(remeshed.report.max_distance, 0.025);
}

// Rounding grows by the many steps but decides nothing.
TEST(Remesh, TurnedMovedAndScaledAlike)
{
  const TriangleMesh input = jittered(12, ellipsoid(2, 1.3, 1));
  TriangleMesh other = input;
  other.points = 1e-6 * (input.points * some_turn().transpose());
  other = moved(other, 1e-5 * Vector3(1, -2, 3));
  const Remeshed first = remesh(input, 1280), second = remesh(other, 1280);
  EXPECT_EQ(first.mesh.triangles, second.mesh.triangles);
  const TriangleMesh expected =
    moved({ 1e-6 * (first.mesh.points * some_turn().transpose()), {} }, 1e-5 * Vector3(1, -2, 3));
  EXPECT_LT((second.mesh.points - expected.points).cwiseAbs().maxCoeff(), 1e-6 * 1e-6);
  EXPECT_NEAR(first.report.rms_distance, second.report.rms_distance, 1e-6);
  EXPECT_NEAR(first.report.volume_error, second.report.volume_error, 1e-6);
}

TEST(Remesh, IsDeterministic)
{
  const TriangleMesh input = meridians(40, 40, ellipsoid(1, 1, prolate_05));
  const Remeshed first = remesh(input, 500), second = remesh(input, 500);
  EXPECT_EQ(first.mesh.points, second.mesh.points);
  EXPECT_EQ(first.mesh.triangles, second.mesh.triangles);
}

TEST(Remesh, SaysWhatCannotBe)
{
  EXPECT_THAT(refusal(sphere(), 18), HasSubstr("triangles = 18"));
  EXPECT_THAT(refusal(sphere(), 2'000'000), HasSubstr("20 to 200000"));
  const std::string text = refusal(jittered(20, ellipsoid(1, 1, prolate_04)), 20);
  EXPECT_THAT(text, HasSubstr("20 triangles are too few"));
  EXPECT_THAT(text, HasSubstr("radii off the new surface"));
  EXPECT_THAT(text, HasSubstr("raise triangles"));
}

}
