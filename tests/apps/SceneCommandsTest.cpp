// vesicle new, vesicle check.

#include "Command.h"

#include "solver/scene/SceneFile.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <iterator>
#include <string>

namespace vesicle::test
{
namespace
{

using Json = nlohmann::json;
namespace fs = std::filesystem;

const fs::path scenes = fs::path(VESICLE_SOURCE_DIR) / "data" / "scenes";

void expect_in(const std::string& text, const std::string& part)
{
  EXPECT_NE(text.find(part), std::string::npos) << part << " isn't in:\n" << text;
}

Json check(const TemporaryFolder& folder, std::vector<std::string> arguments)
{
  arguments.insert(arguments.begin(), "check");
  arguments.push_back("--json");
  const auto outcome = vesicle_command(folder.path(), arguments);
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  return Json::parse(outcome.output);
}

}

TEST(New, GivesEveryShippedSceneToTheByte)
{
  const TemporaryFolder folder;
  const std::string list = vesicle_command(folder.path(), { "new" }).output;
  for (const auto& entry : fs::directory_iterator(scenes))
  {
    const std::string name = entry.path().stem().string();
    expect_in(list, name);
    const auto outcome = vesicle_command(folder.path(), { "new", name });
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_EQ(outcome.output, bytes_of(entry.path()));
  }
}

TEST(New, WritesAFileButNeverOverOne)
{
  const TemporaryFolder folder;
  const std::vector<std::string> command{ "new", "pear", "-o", "mine.toml" };
  EXPECT_EQ(vesicle_command(folder.path(), command).code, 0);
  EXPECT_EQ(bytes_of(folder / "mine.toml"), bytes_of(scenes / "pear.toml"));
  std::ofstream(folder / "mine.toml", std::ios::app) << "# mine\n";
  const std::string mine = bytes_of(folder / "mine.toml");
  const auto outcome = vesicle_command(folder.path(), command);
  EXPECT_EQ(outcome.code, 2);
  expect_in(outcome.errors, "mine.toml: is there already");
  EXPECT_EQ(bytes_of(folder / "mine.toml"), mine);
}

TEST(New, NamesWhatWasProbablyMeant)
{
  const TemporaryFolder folder;
  const auto outcome = vesicle_command(folder.path(), { "new", "peer" });
  EXPECT_EQ(outcome.code, 2);
  expect_in(outcome.errors, "did you mean 'pear'?");
  expect_in(outcome.errors, "tank-treading");
}

TEST(Check, SaysWhatTheSceneIs)
{
  const TemporaryFolder folder;
  const Json found = check(folder, { scenes / "pear.toml" });
  EXPECT_DOUBLE_EQ(found["numbers"]["bond"].get<double>(), 10);
  EXPECT_TRUE(found["numbers"]["capillary"].is_null());
  EXPECT_NEAR(found["numbers"]["r0"].get<double>(), 1, 1e-12);
  EXPECT_NEAR(found["numbers"]["time_unit"].get<double>(), 1, 1e-12);
  // The discrete surface has it to 1e-6.
  EXPECT_NEAR(found["numbers"]["reduced_volume"].get<double>(), 0.95, 1e-6);
  EXPECT_EQ(found["numbers"]["viscosity_ratio"], 1);
  EXPECT_EQ(found["mesh"]["triangles"], 1280);
  EXPECT_EQ(found["mesh"]["vertices"], 642);
  EXPECT_LE(found["mesh"]["min_edge"], found["mesh"]["mean_edge"]);
  EXPECT_LE(found["mesh"]["mean_edge"], found["mesh"]["max_edge"]);
  EXPECT_EQ(found["cost"]["least_steps"], 24); // one an output at the least
  EXPECT_EQ(found["cost"]["frames"], 25);
  EXPECT_EQ(found["warnings"], "");
  // In SI: r0 = 10 µm, EB = 1e-19 J, μ = 1 mPa s, so that μ r0³/EB = 10 s, Ca = rate times that.
  std::ofstream(folder / "si.toml") << R"(
[vesicle]
shape = "sphere"
radius = 1e-5
triangles = 80
[membrane]
bending_rigidity = 1e-19
[fluid]
viscosity = 1e-3
[flow]
kind = "shear"
rate = 2.0
[time]
end = 1
output_every = 0.5
)";
  const Json si = check(folder, { "si.toml" });
  EXPECT_NEAR(si["numbers"]["time_unit"].get<double>(), 10, 1e-9);
  EXPECT_NEAR(si["numbers"]["capillary"].get<double>(), 20, 1e-8);
  EXPECT_TRUE(si["numbers"]["bond"].is_null());
}

TEST(Check, PrintsEverySettingAsASceneThatReadsBack)
{
  const TemporaryFolder folder;
  const auto outcome = vesicle_command(
    folder.path(), { "check", scenes / "tank-treading.toml", "--set", "time.tolerance=0.002" });
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  const auto end = outcome.output.find("\nnumbers\n");
  ASSERT_NE(end, std::string::npos);
  const std::string settings = outcome.output.substr(0, end);
  const Scene scene = read_scene(scenes / "tank-treading.toml", { "time.tolerance=0.002" });
  EXPECT_EQ(write_scene(parse_scene(settings, "settings")), write_scene(scene));
  expect_in(settings, "by default");
  std::istringstream lines(settings);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("tolerance") || line.starts_with("kind"))
      EXPECT_EQ(line.find("by default"), std::string::npos) << line;
    else if (line.starts_with("viscosity "))
      expect_in(line, "pressure × time; by default");
}

TEST(Check, WarnsAsARunWould)
{
  const TemporaryFolder folder;
  std::ofstream(folder / "strange.toml") << R"(
[vesicle]
shape = "sphere"
triangles = 80
[membrane]
bending_rigidity = 1e-5
[flow]
kind = "shear"
rate = 1.0
[time]
end = 1
output_every = 0.5
)";
  expect_in(check(folder, { "strange.toml" })["warnings"], "one system of units?");
  // A run that is there already.
  fs::create_directory(folder / "strange");
  std::ofstream(folder / "strange" / "strange.csv") << "step\n";
  expect_in(check(folder, { "strange.toml" })["warnings"], "there is a run already");
  expect_in(vesicle_command(folder.path(), { "check", "strange.toml" }).output, "\nwarnings\n");
}

TEST(Check, RunsNothingAndWritesNothing)
{
  const TemporaryFolder folder;
  write_scene_file(folder.path());
  EXPECT_EQ(vesicle_command(folder.path(), { "check", "pear.toml" }).code, 0);
  // The scene, and what the test itself keeps of the program's words.
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 3);
}

TEST(Check, EndsAsARunWould)
{
  const TemporaryFolder folder;
  write_scene_file(folder.path());
  const auto outcome =
    vesicle_command(folder.path(), { "check", "pear.toml", "--set", "flow.rat=2" });
  EXPECT_EQ(outcome.code, 2);
  expect_in(outcome.errors, "did you mean 'rate'?");
  std::ofstream(folder / "bad.toml")
    << "[vesicle]\nshape = \"sphere\"\ntriangles = 80\nradios = 2\n";
  const auto bad = vesicle_command(folder.path(), { "check", "bad.toml" });
  EXPECT_EQ(bad.code, 2);
  expect_in(bad.errors, "bad.toml:4");
  expect_in(bad.errors, "radius");
  expect_usage_errors(folder.path(),
    { { "check" }, { "check", "none.toml" },
      { "check", "pear.toml", "--set", "vesicle.triangles=100000000" } });
}

TEST(Check, OfAnEquilibriumThereIsNoRunInTime)
{
  const TemporaryFolder folder;
  std::ofstream(folder / "rest.toml") << R"(
[vesicle]
shape = "prolate"
reduced_volume = 0.9
triangles = 80
[membrane]
bending_rigidity = 1
[time]
end = "equilibrium"
)";
  const Json found = check(folder, { "rest.toml" });
  EXPECT_TRUE(found["numbers"]["time_unit"].is_null());
  EXPECT_TRUE(found["cost"]["step_seconds"].is_null());
  EXPECT_NEAR(found["numbers"]["reduced_volume"].get<double>(), 0.9, 1e-6);
}

}
