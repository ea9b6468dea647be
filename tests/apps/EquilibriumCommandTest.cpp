#include "Command.h"

#include "solver/files/FileBytes.h"
#include "solver/state/Table.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace vesicle::test
{
namespace
{

using Json = nlohmann::json;

Json equilibrium(const std::filesystem::path& folder, std::vector<std::string> arguments)
{
  arguments.insert(arguments.begin(), "equilibrium");
  arguments.push_back("--json");
  const auto outcome = vesicle_command(folder, arguments);
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  return Json::parse(outcome.output);
}

void write_scene(const std::filesystem::path& file, const std::string& more,
  const std::string& time = "end = \"steady\"\noutput_every = 1\n")
{
  std::ofstream(file) << R"(
[vesicle]
shape = "prolate"
reduced_volume = 0.8
radius = 2.0
triangles = 320
[membrane]
bending_rigidity = 3.0
[time]
)" << time << more;
}

}

TEST(EquilibriumCommand, WritesTheMeshAndSaysWhatItIs)
{
  const TemporaryFolder folder;
  const Json report = equilibrium(folder.path(),
    { "--branch", "oblate", "--reduced-volume", "0.8", "--triangles", "320", "-o", "o.vtu" });
  EXPECT_EQ(report["branch"], "oblate");
  EXPECT_EQ(report["triangles"], 320);
  EXPECT_NEAR(report["reduced_volume"].get<double>(), 0.8, 1e-10);
  EXPECT_NEAR(report["energy_over_8pi"].get<double>(), 1.452538629, 1e-3);
  EXPECT_NEAR(report["energy_error"].get<double>(), 0, 1e-3);
  EXPECT_NEAR(report["tension"].get<double>(), -4.985, 0.05);
  EXPECT_NEAR(report["pressure"].get<double>(), -11.570, 0.1);
  EXPECT_FALSE(report["stable"].get<bool>());
  EXPECT_LT(report["lowest_eigenvalues"][0].get<double>(), -1);

  const auto info = vesicle_command(folder.path(), { "info", "o.vtu", "--json" });
  const Json mesh = Json::parse(info.output);
  EXPECT_EQ(mesh["basis"], "loop");
  EXPECT_NEAR(mesh["reduced_volume"].get<double>(), 0.8, 1e-10);
  EXPECT_NEAR(
    mesh["energy_over_8pi"].get<double>(), report["energy_over_8pi"].get<double>(), 1e-10);
}

TEST(EquilibriumCommand, FollowsAnUnstableShape)
{
  const TemporaryFolder folder;
  const Json report = equilibrium(folder.path(),
    { "--branch", "oblate", "--reduced-volume", "0.8", "--triangles", "320", "--follow" });
  EXPECT_TRUE(report["stable"].get<bool>());
  EXPECT_NEAR(report["energy_over_8pi"].get<double>(), 1.387440432, 3e-3); // the prolate's
  EXPECT_TRUE(report["energy_error"].is_null());
}

TEST(EquilibriumCommand, TakesAScene)
{
  const TemporaryFolder folder;
  write_scene(folder.path() / "rest.toml", "");
  const Json report = equilibrium(folder.path(), { "rest.toml" });
  EXPECT_TRUE(report["branch"].is_null());
  EXPECT_NEAR(report["energy_over_8pi"].get<double>(), 1.387440432, 2e-3);
  EXPECT_TRUE(report["stable"].get<bool>());
  // In the scene's units: r0 = 2.
  const Json mesh =
    Json::parse(vesicle_command(folder.path(), { "info", "rest.vtu", "--json" }).output);
  EXPECT_NEAR(mesh["volume"].get<double>(), 4 * 3.141592653589793 / 3 * 8, 1e-4);
}

// No output_every, no steps: the shape and what it is.
TEST(EquilibriumCommand, IsWhatARunToAnEquilibriumDoes)
{
  const TemporaryFolder folder;
  write_scene(folder.path() / "rest.toml", "", "end = \"equilibrium\"\n");
  const auto outcome = vesicle_command(folder.path(), { "run", "rest.toml" });
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  const Json report = Json::parse(read_file(folder.path() / "rest" / "summary.json"));
  EXPECT_NEAR(report["energy_over_8pi"].get<double>(), 1.387440432, 2e-3);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "rest" / "rest.vtu"));
  EXPECT_EQ(vesicle_command(folder.path(), { "run", "rest.toml" }).code, 2);
  EXPECT_EQ(vesicle_command(folder.path(), { "run", "rest.toml", "--overwrite" }).code, 0);
}

TEST(EquilibriumCommand, RefusesWhatHasNone)
{
  const TemporaryFolder folder;
  write_scene(folder.path() / "shear.toml", "[flow]\nkind = \"shear\"\nrate = 1\n");
  write_scene(folder.path() / "pear.toml", "[gravity]\nbond_number = 10\n");
  write_scene(
    folder.path() / "both.toml", "[gravity]\nbond_number = 10\n", "end = \"equilibrium\"\n");
  EXPECT_EQ(vesicle_command(folder.path(), { "run", "both.toml" }).code, 2);
  expect_usage_errors(folder.path(),
    { { "equilibrium", "shear.toml" }, { "equilibrium", "pear.toml" }, { "equilibrium" },
      { "equilibrium", "--branch", "torus", "--reduced-volume", "0.6" },
      { "equilibrium", "--branch", "oblate" },
      { "equilibrium", "--branch", "stomatocyte", "--reduced-volume", "0.8" },
      { "equilibrium", "--sweep", "1:0.5" },
      { "equilibrium", "--branch", "oblate", "--reduced-volume", "0.8", "-o", "x.xyz" } });
}

TEST(EquilibriumCommand, SweepsAllBranches)
{
  const TemporaryFolder folder;
  const auto outcome = vesicle_command(folder.path(),
    { "equilibrium", "--sweep", ".6:.8", "--step", "0.2", "--triangles", "320", "-o", "e" });
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  const Table table = parse_table(read_file(folder.path() / "e" / "equilibria.csv"));
  ASSERT_EQ(table.rows.size(), 5U); // there is no stomatocyte of .8
  const auto error = table.column("energy_error"), stable = table.column("stable");
  for (const double e : error)
    EXPECT_NEAR(e, 0, 2e-3);
  EXPECT_EQ(stable, (std::vector<double>{ 1, 1, 1, 0, 1 }));
}

}
