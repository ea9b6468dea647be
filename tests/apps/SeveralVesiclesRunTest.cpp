// What a run of several vesicles leaves behind, and going on with one; vesicle fill.

#include "Command.h"
#include "RunFiles.h"

#include "solver/scene/SceneFile.h"
#include "vtkfilters/Filters/MeshFiles.h"
#include "vtkfilters/Filters/SeriesFile.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <sstream>

#include <unistd.h>

namespace vesicle::test
{
namespace
{

class SeveralVesiclesRun : public testing::Test
{
protected:
  SeveralVesiclesRun()
  {
    std::ofstream(folder / "two.toml") << R"(
[[vesicle]]
shape = "prolate"
reduced_volume = 0.9
triangles = 80
center = [0, 0, 2]
[[vesicle]]
shape = "sphere"
triangles = 120
center = [0, 0, -2]
[membrane]
bending_rigidity = 1
[gravity]
bond_number = 5
[time]
end = 0.4
output_every = 0.05
step = 0.01
[movie]
size = [320, 180]
chart = "velocity"
)";
  }

  std::vector<std::string> quiet(const std::string& output) const
  {
    return { "run", "two.toml", "--no-movie", "--no-plots", "--quiet", "-o", output };
  }

  std::vector<std::string> table_of(const std::string& output) const
  {
    std::istringstream text(bytes_of(folder / (output + "/two.csv")));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);)
    {
      lines.push_back(line);
    }
    return lines;
  }

  void expect_same_files(const std::string& a, const std::string& b) const
  {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / a))
    {
      const auto name = std::filesystem::relative(entry.path(), folder / a);
      if (entry.is_regular_file() && name != "summary.json")
      {
        EXPECT_EQ(bytes_of(entry.path()), bytes_of(folder / b / name)) << name;
      }
    }
  }

  TemporaryFolder folder;
};

}

TEST_F(SeveralVesiclesRun, LeavesRowsOfEachAndOneGrid)
{
  const auto outcome = vesicle_command(folder.path(),
    { "run", "two.toml", "-o", "run", "--set", "time.end=0.1", "--set", "movie.color=Vesicle_Id" });
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  expect_complete_run(folder / "run", 3);

  const auto table = table_of("run");
  ASSERT_GE(table.size(), 5u);
  EXPECT_TRUE(table[0].starts_with("vesicle,step,time,dt,"));
  EXPECT_EQ(table.size() % 2, 1u);
  for (std::size_t i = 1; i < table.size(); ++i)
  {
    const std::size_t step = (i - 1) / 2;
    EXPECT_TRUE(
      table[i].starts_with(std::to_string((i - 1) % 2) + ',' + std::to_string(step) + ','))
      << table[i].substr(0, 20);
  }

  const auto frame = read_mesh(read_series(folder / "run/two.pvd").back().file);
  vtkDataArray* ids = frame->GetPointData()->GetArray("Vesicle_Id");
  ASSERT_TRUE(ids);
  EXPECT_EQ(frame->GetNumberOfPolys(), 200);
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    EXPECT_EQ(ids->GetComponent(i, 0), i < 42 ? 0 : 1);
    EXPECT_EQ(frame->GetPoint(i)[2] > 0, i < 42);
  }
  EXPECT_EQ(frame->GetFieldData()->GetArray("Volume")->GetNumberOfTuples(), 2);

  const auto summary = nlohmann::json::parse(bytes_of(folder / "run/summary.json"));
  EXPECT_EQ(summary["vesicles"], 2);
  ASSERT_EQ(summary["final"].size(), 2u);
  EXPECT_GT(summary["final"][0]["centroid_z"], summary["final"][1]["centroid_z"]);

  const auto info = vesicle_command(folder.path(), { "info", "run" });
  EXPECT_EQ(info.code, 0);
  EXPECT_NE(info.output.find("vesicles         2"), std::string::npos) << info.output;
  const auto json =
    nlohmann::json::parse(vesicle_command(folder.path(), { "info", "run", "--json" }).output);
  EXPECT_EQ(json["last"].size(), 2u);
}

TEST_F(SeveralVesiclesRun, KilledAndUninterruptedAreTheSameToTheByte)
{
  ASSERT_EQ(vesicle_command(folder.path(), quiet("straight")).code, 0);
  {
    Command run(VESICLE_COMMAND, folder.path(), quiet("killed"));
    while (run.running() &&
      (!std::filesystem::exists(folder / "killed/two.csv") || table_of("killed").size() < 20))
    {
      usleep(1000);
    }
    run.signal(SIGKILL);
    run.wait();
  }
  auto arguments = quiet("killed");
  arguments.emplace_back("--resume");
  const auto outcome = vesicle_command(folder.path(), arguments);
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  expect_same_files("straight", "killed");
}

TEST_F(SeveralVesiclesRun, AnotherNumberOfVesiclesCantGoOn)
{
  auto arguments = quiet("run");
  arguments.insert(arguments.end(), { "--set", "time.end=0.05" });
  ASSERT_EQ(vesicle_command(folder.path(), arguments).code, 0);
  const std::string scene = bytes_of(folder / "two.toml");
  const auto second = scene.rfind("[[vesicle]]"), end = scene.find("[membrane]");
  std::ofstream(folder / "two.toml") << scene.substr(0, second) + scene.substr(end);
  arguments.emplace_back("--resume");
  const auto outcome = vesicle_command(folder.path(), arguments);
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.errors.find("the scene is not the one of this run"), std::string::npos)
    << outcome.errors;
}

TEST_F(SeveralVesiclesRun, VesiclesThatOverlapAreRefused)
{
  auto arguments = quiet("run");
  arguments.insert(arguments.end(), { "--set", "vesicle.1.center=[0, 0, 1]" });
  const auto outcome = vesicle_command(folder.path(), arguments);
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.errors.find("vesicles 0 and 1 overlap near ("), std::string::npos)
    << outcome.errors;
}

TEST_F(SeveralVesiclesRun, CheckCountsAll)
{
  const auto outcome = vesicle_command(folder.path(), { "check", "two.toml", "--json" });
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  const auto check = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(check["mesh"]["vesicles"], 2);
  EXPECT_EQ(check["mesh"]["triangles"], 200);
}

TEST_F(SeveralVesiclesRun, FillWritesAScene)
{
  const std::vector<std::string> fill{ "fill", "two.toml", "--count", "5", "--box", "7", "7", "7",
    "--seed", "3", "-o" };
  auto arguments = fill;
  arguments.emplace_back("many.toml");
  const auto outcome = vesicle_command(folder.path(), arguments);
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  const Scene scene = read_scene(folder / "many.toml");
  ASSERT_EQ(scene.vesicles(), 5u);
  for (std::size_t v = 0; v < 5; ++v)
  {
    EXPECT_EQ(scene.alone(v).vesicle.shape.kind, ShapeRequest::Kind::prolate);
    EXPECT_EQ(scene.alone(v).gravity->bond_number, 5);
    EXPECT_TRUE(scene.alone(v).vesicle.rotation);
    EXPECT_LT(scene.alone(v).vesicle.center.cwiseAbs().maxCoeff(), 3.5);
  }
  EXPECT_EQ(vesicle_command(folder.path(), { "check", "many.toml" }).code, 0);

  arguments = fill;
  arguments.emplace_back("many.vtu");
  ASSERT_EQ(vesicle_command(folder.path(), arguments).code, 0);
  const auto mesh = read_mesh(folder / "many.vtu");
  EXPECT_EQ(mesh->GetNumberOfPolys(), 5 * 80);
  EXPECT_EQ(mesh->GetPointData()->GetArray("Vesicle_Id")->GetRange()[1], 4);

  arguments = fill;
  for (const char* more :
    { "wall.toml", "--center", "0", "0", "2", "--set", "wall.normal=[0,0,1]" })
    arguments.emplace_back(more);
  ASSERT_EQ(vesicle_command(folder.path(), arguments).code, 0);
  const Scene above = read_scene(folder / "wall.toml");
  ASSERT_TRUE(above.wall);
  for (std::size_t v = 0; v < 5; ++v)
    EXPECT_GT(above.alone(v).vesicle.center.z(), 0);
  EXPECT_EQ(vesicle_command(folder.path(), { "check", "wall.toml" }).code, 0); // none crosses it

  const auto crowded = vesicle_command(
    folder.path(), { "fill", "two.toml", "--count", "500", "--ball", "3", "-o", "none.toml" });
  EXPECT_EQ(crowded.code, 2);
  EXPECT_NE(crowded.errors.find("of 500 vesicles fitted into the region"), std::string::npos)
    << crowded.errors;
}

}
