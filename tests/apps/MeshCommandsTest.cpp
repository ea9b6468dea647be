#include "Command.h"

#include "vtkfilters/Filters/MeshFiles.h"

#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

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
    { "shape", "--help" }, { "curvature", "--help" }, { "info", "--help" },
    { "render", "--help" }, { "validate", "--help" } };
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
  const std::vector<std::vector<std::string>> commands{ {}, { "dance" }, { "run" },
    { "info", "--colour" }, { "shape", "cube" }, { "run", "a.toml", "--resume", "--overwrite" },
    { "run", "a.toml", "--threads", "0" }, { "info", "mesh.xyz" }, { "info", "none.vtu" } };
  for (const auto& arguments : commands)
  {
    const auto outcome = vesicle_command(folder.path(), arguments);
    EXPECT_EQ(outcome.code, 2) << outcome.output;
    EXPECT_FALSE(outcome.errors.empty());
  }
}

TEST(Shape, HasWhatWasAskedFor)
{
  const TemporaryFolder folder;
  const auto outcome = vesicle_command(folder.path(),
    { "shape", "oblate", "--reduced-volume", "0.8", "--triangles", "320", "-o", "disc.stl" });
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  const Json report = info(folder.path(), "disc.stl");
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

}
