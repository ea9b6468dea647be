#include "Command.h"

#include "solver/mesh/shapes/GeodesicSphere.h"
#include "vtkfilters/Filters/MeshConversion.h"
#include "vtkfilters/Filters/MeshFiles.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace vesicle::test
{
namespace
{

using Json = nlohmann::json;

Json info(const std::filesystem::path& folder, const std::string& file)
{
  const auto outcome = vesicle_command(folder, { "info", file, "--json" });
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  return Json::parse(outcome.output);
}

}

TEST(Help, IsThereForAllWithAnExample)
{
  const TemporaryFolder folder;
  const std::vector<std::vector<std::string>> commands{ { "--help" }, { "run", "--help" },
    { "shape", "--help" }, { "equilibrium", "--help" }, { "curvature", "--help" },
    { "info", "--help" }, { "render", "--help" }, { "validate", "--help" }, { "new", "--help" },
    { "check", "--help" }, { "repair", "--help" }, { "compare", "--help" }, { "convert", "--help" },
    { "sweep", "--help" } };
  for (const auto& arguments : commands)
  {
    const auto outcome = vesicle_command(folder.path(), arguments);
    EXPECT_EQ(outcome.code, 0) << arguments[0];
    EXPECT_NE(outcome.output.find("Example: vesicle "), std::string::npos) << arguments[0];
  }
}

TEST(Usage, ErrorsAreTwo)
{
  const TemporaryFolder folder;
  expect_usage_errors(folder.path(),
    { {}, { "dance" }, { "run" }, { "info", "--colour" }, { "shape", "cube" },
      { "run", "a.toml", "--resume", "--overwrite" }, { "run", "a.toml", "--threads", "0" },
      { "info", "mesh.xyz" }, { "info", "none.vtu" } });
}

TEST(Shape, HasWhatWasAskedFor)
{
  const TemporaryFolder folder;
  const auto outcome = vesicle_command(folder.path(),
    { "shape", "oblate", "--reduced-volume", "0.8", "--triangles", "320", "--basis", "linear", "-o",
      "disc.stl" });
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_EQ(outcome.errors, "");
  const Json report = info(folder.path(), "disc.stl");
  EXPECT_EQ(report["basis"], "linear");
  EXPECT_EQ(report["vertices"], 162);
  EXPECT_EQ(report["triangles"], 320);
  EXPECT_EQ(report["closed"], true);
  EXPECT_EQ(report["oriented"], true);
  EXPECT_EQ(report["components"], 1);
  EXPECT_EQ(report["genus"], 0);
  EXPECT_NEAR(report["reduced_volume"].get<double>(), 0.8, 1e-5);
  for (const char* key : { "area", "volume", "energy_over_8pi", "min_angle_deg", "edge_ratio" })
  {
    EXPECT_GT(report[key].get<double>(), 0) << key;
  }
}

TEST(Shape, FilesWithFieldDataSayWhichSurfaceHasTheReducedVolume)
{
  const TemporaryFolder folder;
  for (const std::string basis : { "loop", "linear" })
  {
    for (const std::string file : { "disc.vtu", "disc.vtp", "disc.vtk" })
    {
      const auto outcome = vesicle_command(folder.path(),
        { "shape", "discocyte", "--reduced-volume", "0.7", "--basis", basis, "-o", file });
      ASSERT_EQ(outcome.code, 0) << outcome.errors;
      const Json report = info(folder.path(), file);
      EXPECT_EQ(report["basis"], basis) << file;
      EXPECT_NEAR(report["reduced_volume"].get<double>(), 0.7, 1e-6) << file;
    }
  }
}

TEST(Shape, IsOnLoopsSurfaceUnlessToldOtherwise)
{
  const TemporaryFolder folder;
  const auto outcome =
    vesicle_command(folder.path(), { "shape", "oblate", "--reduced-volume", "0.8" });
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("surface          Loop\n"), std::string::npos) << outcome.output;
  EXPECT_EQ(info(folder.path(), "oblate.vtu")["basis"], "loop");
}

TEST(Shape, NowhereToWriteIsFour)
{
  const TemporaryFolder folder;
  EXPECT_EQ(vesicle_command(folder.path(), { "shape", "sphere", "-o", "none/mesh.vtu" }).code, 4);
  EXPECT_EQ(vesicle_command(folder.path(), { "shape", "sphere", "-o", "mesh.xyz" }).code, 2);
}

TEST(Info, UndefinedNumbersAreNull)
{
  const TemporaryFolder folder;
  std::ofstream(folder / "square.off") << "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";
  const Json report = info(folder.path(), "square.off");
  EXPECT_EQ(report["closed"], false);
  EXPECT_TRUE(report["volume"].is_null());
  EXPECT_TRUE(report["energy_over_8pi"].is_null());
  EXPECT_DOUBLE_EQ(report["area"].get<double>(), 1);
}

// A frame that was cut open has no Loop surface.
TEST(Info, MeasuresTheTrianglesWhereThereIsNoLoopSurface)
{
  const TemporaryFolder folder;
  ASSERT_EQ(vesicle_command(folder.path(), { "shape", "sphere", "-o", "sphere.vtp" }).code, 0);
  const auto sphere = read_mesh(folder / "sphere.vtp");
  TriangleMesh mesh = to_mesh(sphere);
  mesh.triangles = mesh.triangles.bottomRows(mesh.triangles.rows() - 1).eval();
  const auto open = to_polydata(mesh);
  open->GetFieldData()->ShallowCopy(sphere->GetFieldData());
  write_mesh(open, folder / "open.vtp");
  const Json report = info(folder.path(), "open.vtp");
  EXPECT_EQ(report["basis"], "linear");
  EXPECT_TRUE(report["volume"].is_null());
}

TEST(Curvature, WritesTheArraysAndTellsOfBorders)
{
  const TemporaryFolder folder;
  ASSERT_EQ(vesicle_command(folder.path(), { "shape", "sphere", "-o", "sphere.ply" }).code, 0);
  auto outcome = vesicle_command(folder.path(), { "curvature", "sphere.ply", "-o", "sphere.vtp" });
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_EQ(outcome.errors, "");
  const auto surface = read_mesh(folder / "sphere.vtp");
  EXPECT_TRUE(surface->GetPointData()->HasArray("Mean_Curvature"));
  EXPECT_TRUE(surface->GetPointData()->HasArray("Bending_Force"));
  std::ofstream(folder / "square.off") << "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";
  outcome = vesicle_command(folder.path(), { "curvature", "square.off", "-o", "square.vtu" });
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(outcome.errors.find("undefined at 4 of 4"), std::string::npos) << outcome.errors;
}

// A sphere of 1,280 triangles with its points off by 1% of the radius, a fifteenth of an edge.
TEST(Curvature, NamesARadiusForNoisyMeshes)
{
  const TemporaryFolder folder;
  TriangleMesh mesh = geodesic_sphere(8);
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 0.01);
  for (auto x : mesh.points.rowwise())
  {
    x *= 1 + noise(random);
  }
  write_mesh(to_polydata(mesh), folder / "noisy.vtp");
  auto outcome = vesicle_command(folder.path(), { "curvature", "noisy.vtp", "-o", "all.vtp" });
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  const std::string::size_type named = outcome.errors.find("--radius) of ");
  ASSERT_NE(named, std::string::npos) << outcome.errors;
  const std::string radius = std::to_string(std::stod(outcome.errors.substr(named + 13)));
  outcome = vesicle_command(
    folder.path(), { "curvature", "noisy.vtp", "--radius", radius, "--all", "-o", "all.vtp" });
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.errors, "");
  const auto surface = read_mesh(folder / "all.vtp");
  for (const char* name :
    { "Mean_Curvature_Error", "Maximum_Curvature", "Minimum_Curvature", "Maximum_Direction",
      "Minimum_Direction", "Curvedness", "Shape_Index", "Willmore_Density" })
  {
    EXPECT_TRUE(surface->GetPointData()->HasArray(name)) << name;
  }
  EXPECT_NEAR(surface->GetPointData()->GetArray("Mean_Curvature")->GetComponent(0, 0), 1, 0.15);
  outcome = vesicle_command(
    folder.path(), { "curvature", "noisy.vtp", "--rings", "4", "--no-force", "-o", "few.vtp" });
  EXPECT_EQ(outcome.code, 0);
  EXPECT_FALSE(read_mesh(folder / "few.vtp")->GetPointData()->HasArray("Bending_Force"));
  for (const auto& [radii, text] :
    { std::pair(std::vector<std::string>{ "--radius", "9" }, "a fit radius of 9 is too large"),
      { { "--radius", "1", "--rings", "4" }, "--rings" }, { { "--radius", "0" }, "--radius" } })
  {
    std::vector<std::string> arguments{ "curvature", "noisy.vtp", "-o", "none.vtp" };
    arguments.insert(arguments.end(), radii.begin(), radii.end());
    outcome = vesicle_command(folder.path(), arguments);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.errors.find(text), std::string::npos) << outcome.errors;
  }
}

// H on a torus is between (R − 2r)/(2r(R − r)) and (R + 2r)/(2r(R + r)), on average over the area
// 1/(2r), and K 0. Of H = (R + 2r c)/(2r(R + r c)), c = cos θ, half of the area has c below the one
// for which the area between θ and π, ∝ π − θ − (r/R) sin θ, is π/2.
TEST(Curvature, SummaryOfATorus)
{
  const TemporaryFolder folder;
  constexpr double R = 3, r = 1;
  const int around = 192, across = 96;
  TriangleMesh mesh;
  mesh.points.resize(around * across, 3);
  mesh.triangles.resize(2 * around * across, 3);
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * j / across;
      const int a = i * across + j, b = (i + 1) % around * across + j,
                c = i * across + (j + 1) % across, d = (i + 1) % around * across + (j + 1) % across;
      const double distance = R + r * std::cos(v);
      mesh.points.row(a) << distance * std::cos(u), distance * std::sin(u), r * std::sin(v);
      mesh.triangles.row(2 * a) << a, b, d;
      mesh.triangles.row(2 * a + 1) << a, d, c;
    }
  }
  write_mesh(to_polydata(mesh), folder / "torus.vtp");
  const auto outcome = vesicle_command(folder.path(),
    { "curvature", "torus.vtp", "--summary", "--all", "--summary-file", "torus.json" });
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  for (const char* name : { "Mean_Curvature", "Gauss_Curvature", "Curvedness", "median", "###" })
  {
    EXPECT_NE(outcome.output.find(name), std::string::npos) << name;
  }
  const Json summary = Json::parse(bytes_of(folder / "torus.json"));
  const Json& H = summary["Mean_Curvature"];
  const double flat_error = 2e-3; // (π/96)², the relative error of flat triangles' areas
  const double area = 4 * std::numbers::pi * std::numbers::pi * R * r;
  EXPECT_NEAR(H["area"].get<double>() / area, 1, flat_error);
  EXPECT_NEAR(H["mean"].get<double>(), 1 / (2 * r), flat_error);
  EXPECT_NEAR(summary["Gauss_Curvature"]["mean"].get<double>(), 0, flat_error);
  EXPECT_NEAR(H["least"].get<double>(), (R - 2 * r) / (2 * r * (R - r)), flat_error);
  EXPECT_NEAR(H["greatest"].get<double>(), (R + 2 * r) / (2 * r * (R + r)), flat_error);
  double angle = 1;
  for (int i = 0; i < 50; ++i)
  {
    angle = std::numbers::pi / 2 - r / R * std::sin(angle);
  }
  const double c = std::cos(angle), median = (R + 2 * r * c) / (2 * r * (R + r * c));
  // One row of vertices more or less: 1/96 of the circle.
  const double row = 2 * std::numbers::pi / across * R / (2 * (R + r * c) * (R + r * c));
  EXPECT_NEAR(H["percentiles"]["50"].get<double>(), median, row);
  double shares = 0;
  for (const Json& bin : H["histogram"])
  {
    shares += bin["share"].get<double>();
  }
  EXPECT_EQ(H["histogram"].size(), 20);
  EXPECT_NEAR(shares, 1, 1e-9);
  ASSERT_EQ(
    vesicle_command(folder.path(), { "curvature", "torus.vtp", "--summary-file", "torus.csv" })
      .code,
    0);
  EXPECT_EQ(bytes_of(folder / "torus.csv").substr(0, 25), "array,what,from,to,value\n");
  expect_usage_errors(folder.path(),
    { { "curvature", "torus.vtp" }, { "curvature", "torus.vtp", "--summary-file", "torus.txt" },
      { "curvature", "torus.vtp", "--summary", "--bins", "1" } });
}

TEST(Curvature, UndefinedIsZeroOrNaN)
{
  const TemporaryFolder folder;
  std::ofstream(folder / "square.off") << "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";
  for (const std::string undefined : { "zero", "nan" })
  {
    const auto outcome = vesicle_command(
      folder.path(), { "curvature", "square.off", "--undefined", undefined, "-o", "square.vtu" });
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    const auto surface = read_mesh(folder / "square.vtu");
    vtkPointData* arrays = surface->GetPointData();
    EXPECT_EQ(
      std::isnan(arrays->GetArray("Mean_Curvature")->GetComponent(0, 0)), undefined == "nan");
    EXPECT_EQ(arrays->GetArray("Curvature_Valid")->GetComponent(0, 0), 0);
  }
}

}
