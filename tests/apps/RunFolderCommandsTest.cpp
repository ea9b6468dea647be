// vesicle info of a run's folder, vesicle compare, vesicle convert, vesicle sweep.

#include "Command.h"

#include "apps/ParameterGrid.h"

#include "solver/Errors.h"
#include "solver/files/FileLock.h"
#include "solver/mesh/shapes/GeodesicSphere.h"
#include "vtkfilters/Filters/MeshConversion.h"
#include "vtkfilters/Filters/MeshFiles.h"
#include "vtkfilters/Filters/SeriesFile.h"

#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <csignal>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <unistd.h>

namespace vesicle::test
{
namespace
{

using Json = nlohmann::json;
namespace fs = std::filesystem;

Outcome run_pear(
  const TemporaryFolder& folder, const std::string& to, const std::vector<std::string>& more = {})
{
  std::vector<std::string> arguments{ "run", "pear.toml", "-o", to, "--no-movie", "--no-plots",
    "--quiet" };
  arguments.insert(arguments.end(), more.begin(), more.end());
  return vesicle_command(folder.path(), arguments);
}

Json json_of(const TemporaryFolder& folder, std::vector<std::string> arguments)
{
  arguments.push_back("--json");
  const auto outcome = vesicle_command(folder.path(), arguments);
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  return Json::parse(outcome.output);
}

void expect_in(const std::string& text, const std::string& part)
{
  EXPECT_NE(text.find(part), std::string::npos) << part << " isn't in:\n" << text;
}

void write_sphere(const fs::path& file, double radius, const Vector3& centre = { 0, 0, 0 })
{
  TriangleMesh mesh = geodesic_sphere(16);
  mesh.points = ((mesh.points * radius).rowwise() + centre.transpose()).eval();
  write_mesh(to_polydata(mesh), file);
}

std::vector<std::string> lines_of(const std::string& text)
{
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
  {
    lines.push_back(line);
  }
  return lines;
}

}

TEST(RunInfo, SaysHowFarARunHasComeAndWhyItEnded)
{
  const TemporaryFolder folder;
  write_scene_file(folder.path());
  ASSERT_EQ(run_pear(folder, "done").code, 0);
  const Json done = json_of(folder, { "info", "done" });
  EXPECT_EQ(done["state"], "finished");
  EXPECT_EQ(done["time"], 0.5);
  EXPECT_EQ(done["end"], 0.5);
  EXPECT_EQ(done["frames"], 6);
  EXPECT_EQ(done["last_frame"]["time"], 0.5);
  EXPECT_TRUE(fs::exists(folder / done["last_frame"]["file"]));
  const Json summary = Json::parse(bytes_of(folder / "done" / "summary.json"));
  EXPECT_EQ(done["last"]["area_drift"], summary["final"]["area_drift"]);
  expect_in(vesicle_command(folder.path(), { "info", "done" }).output, "time.end was reached");

  // One that a step of its own can't carry on.
  EXPECT_EQ(
    run_pear(folder, "failed", { "--set", "time.step=0.1", "--set", "flow.rate=500" }).code, 3);
  const Json failed = json_of(folder, { "info", "failed" });
  EXPECT_EQ(failed["state"], "failed");
  EXPECT_EQ(failed["reason"], Json::parse(bytes_of(folder / "failed" / "summary.json"))["message"]);
  expect_in(failed["go_on_with"], "pear.toml -o failed --resume");
}

TEST(RunInfo, TellsAKilledRunFromOneUnderWay)
{
  const TemporaryFolder folder;
  write_scene_file(folder.path());
  Command run(VESICLE_COMMAND, folder.path(),
    { "run", "pear.toml", "-o", "long", "--no-movie", "--no-plots", "--set", "time.end=1000" });
  const fs::path table = folder / "long" / "pear.csv";
  for (int i = 0; i < 6000 && !(fs::exists(table) && fs::file_size(table) > 5000); ++i)
  {
    usleep(10'000);
  }
  ASSERT_TRUE(run.running());
  const Json running = json_of(folder, { "info", "long" });
  EXPECT_EQ(running["state"], "running");
  expect_in(running["reason"], "process ");
  EXPECT_EQ(running["go_on_with"], "");
  run.signal(SIGKILL);
  run.wait();
  const Json killed = json_of(folder, { "info", "long" });
  EXPECT_EQ(killed["state"], "killed");
  EXPECT_GE(killed["time"], running["time"]);
  EXPECT_EQ(killed["end"], 1000);
}

TEST(RunInfo, OfAFolderWithoutARunIsAnError)
{
  const TemporaryFolder folder;
  fs::create_directory(folder / "empty");
  const auto outcome = vesicle_command(folder.path(), { "info", "empty" });
  EXPECT_EQ(outcome.code, 2);
  expect_in(outcome.errors, "empty: there is no run in this folder");
}

// Concentric spheres of flat triangles are apart by the difference of their radii, but for what the
// triangles are within their spheres, less than (h/R)²/8 R, h = 0.08.
TEST(Compare, MeshesByTheirDistance)
{
  const TemporaryFolder folder;
  write_sphere(folder / "a.vtp", 1);
  write_sphere(folder / "b.stl", 1.1);
  write_sphere(folder / "moved.vtp", 1, { 0.2, 0, 0 });
  const Json shells = json_of(folder, { "compare", "a.vtp", "b.stl" });
  EXPECT_NEAR(shells["distance"]["mean"].get<double>(), 0.1, 2e-3);
  EXPECT_NEAR(shells["distance"]["largest"].get<double>(), 0.1, 2e-3);
  EXPECT_LT(shells["a"]["area"], shells["b"]["area"]);
  // A sphere moved by d is |d cos θ| off to first order, on average d/2, at most d.
  const Json moved = json_of(folder, { "compare", "a.vtp", "moved.vtp" });
  EXPECT_NEAR(moved["distance"]["largest"].get<double>(), 0.2, 2e-3);
  EXPECT_NEAR(moved["distance"]["mean"].get<double>(), 0.1, 0.01);
  const Json centred = json_of(folder, { "compare", "a.vtp", "moved.vtp", "--centred" });
  EXPECT_LT(centred["distance"]["largest"].get<double>(), 1e-6);
  expect_in(vesicle_command(folder.path(), { "compare", "a.vtp", "b.stl" }).output, "largest");
}

TEST(Compare, RunsAtTheirCommonTimes)
{
  const TemporaryFolder folder;
  write_scene_file(folder.path());
  ASSERT_EQ(run_pear(folder, "a").code, 0);
  ASSERT_EQ(run_pear(folder, "b", { "--set", "time.output_every=0.25" }).code, 0);
  ASSERT_EQ(run_pear(folder, "c", { "--set", "flow.rate=2" }).code, 0);
  const Json same = json_of(folder, { "compare", "a", "a/pear.pvd" });
  EXPECT_EQ(same["settings"].size(), 0);
  ASSERT_EQ(same["moments"].size(), 6);
  for (const Json& moment : same["moments"])
  {
    EXPECT_LT(moment["distance"]["largest"].get<double>(), 1e-14); // rounding
    EXPECT_EQ(moment["values"]["area"][0], moment["values"]["area"][1]);
  }
  // 0 and 0.5 are multiples of both; steps have other lengths, of which the shape knows little.
  const Json steps = json_of(folder, { "compare", "a", "b" });
  ASSERT_EQ(steps["moments"].size(), 2);
  EXPECT_EQ(steps["moments"][1]["time"], 0.5);
  EXPECT_LT(steps["moments"][1]["distance"]["largest"].get<double>(), 0.01);
  const Json rates = json_of(folder, { "compare", "a", "c", "--columns", "inclination_deg" });
  EXPECT_EQ(rates["settings"], (Json{ "A: flow.rate = 1.0", "B: flow.rate = 2.0" }));
  EXPECT_EQ(rates["moments"][5]["values"].size(), 1);
  EXPECT_GT(rates["moments"][5]["distance"]["largest"].get<double>(), 0.01);
  const std::string text = vesicle_command(folder.path(), { "compare", "a", "c" }).output;
  for (const char* part :
    { "settings that differ", "mean distance", "energy_over_8pi", "at t = 0.5" })
  {
    expect_in(text, part);
  }
  auto outcome = vesicle_command(folder.path(), { "compare", "a", "c", "--columns", "aera" });
  EXPECT_EQ(outcome.code, 2);
  expect_in(outcome.errors, "did you mean 'area'?");
  outcome = vesicle_command(folder.path(), { "compare", "a", "a/frames/pear_000000.vtu" });
  EXPECT_EQ(outcome.code, 2);
  expect_in(outcome.errors, "a is a run and a/frames/pear_000000.vtu a mesh");
}

TEST(Convert, MeshesToASeriesAndBack)
{
  const TemporaryFolder folder;
  write_sphere(folder / "a.stl", 1);
  write_sphere(folder / "b.stl", 2);
  auto outcome = vesicle_command(
    folder.path(), { "convert", "a.stl", "b.stl", "-o", "series/both.pvd", "--times", "0,0.5" });
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  for (const char* list : { "series/both.pvd", "series/both.vtu.series" })
  {
    const auto frames = read_series(folder / list);
    ASSERT_EQ(frames.size(), 2u);
    EXPECT_EQ(frames[1].time, 0.5);
    EXPECT_EQ(
      to_mesh(read_mesh(frames[1].file)).points, to_mesh(read_mesh(folder / "b.stl")).points);
  }
  EXPECT_TRUE(fs::exists(folder / "series" / "both.xdmf"));
  outcome = vesicle_command(folder.path(), { "convert", "series/both.pvd", "-o", "back.stl" });
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_EQ(to_mesh(read_mesh(folder / "back_000001.stl")).points,
    to_mesh(read_mesh(folder / "b.stl")).points);
  outcome = vesicle_command(folder.path(), { "convert", "a.stl", "-o", "a.off" });
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_EQ(
    to_mesh(read_mesh(folder / "a.off")).points, to_mesh(read_mesh(folder / "a.stl")).points);
  outcome = vesicle_command(folder.path(), { "convert", "b.stl", "-o", "a.off" });
  EXPECT_EQ(outcome.code, 2);
  expect_in(outcome.errors, "a.off: is there already; replace it by --overwrite");
  EXPECT_EQ(
    vesicle_command(folder.path(), { "convert", "b.stl", "-o", "a.off", "--overwrite" }).code, 0);
  expect_usage_errors(folder.path(),
    { { "convert", "a.stl" }, { "convert", "a.stl", "-o", "a.xyz" },
      { "convert", "a.stl", "b.stl", "-o", "c.pvd", "--times", "0" },
      { "convert", "a.stl", "b.stl", "-o", "c.pvd", "--times", "1,0" } });
}

TEST(ParameterGrid, ListsAndRanges)
{
  using Values = std::vector<std::string>;
  EXPECT_EQ(parse_range("a.b=0.5,1,2").values, (Values{ "0.5", "1", "2" }));
  EXPECT_EQ(parse_range("a.b=.9:.6:.1").values, (Values{ "0.9", "0.8", "0.7", "0.6" }));
  EXPECT_EQ(parse_range("a.b=1:2:.5").values, (Values{ "1.0", "1.5", "2.0" }));
  EXPECT_EQ(parse_range("a.b=80:320:80").values, (Values{ "80", "160", "240", "320" }));
  EXPECT_EQ(parse_range("a.b=0:1:.4").values, (Values{ "0.0", "0.4", "0.8" }));
  EXPECT_EQ(parse_range("v.axis=[0,0,1],[1,0,0]").values, (Values{ "[0,0,1]", "[1,0,0]" }));
  const auto grid = parameter_grid({ parse_range("a.b=1,2"), parse_range("c.d=x,y") });
  ASSERT_EQ(grid.size(), 4u);
  EXPECT_EQ(grid[1].overrides, (Values{ "a.b=1", "c.d=y" }));
  EXPECT_EQ(grid[1].name, "b=1_d=y");
  EXPECT_EQ(parameter_grid({ parse_range("a.b=1"), parse_range("c.b=2") })[0].name, "a.b=1_c.b=2");
  for (const char* bad :
    { "a.b", "a.b=", "=1", "a.b=1,,2", "a.b=1:2:0", "a.b=1:x:1", "a.b=0:1:1e-9" })
  {
    EXPECT_THROW(parse_range(bad), InputError) << bad;
  }
  EXPECT_THROW(parameter_grid({ parse_range("a.b=1,1") }), InputError);
  EXPECT_THROW(parameter_grid({ parse_range("a.b=1"), parse_range("a.b=2") }), InputError);
}

TEST(Sweep, RunsEachSettingInItsFolderAndGoesOn)
{
  const TemporaryFolder folder;
  write_scene_file(folder.path());
  const std::vector<std::string> command{ "sweep", "pear.toml", "--over", "flow.rate=1,2", "--over",
    "vesicle.reduced_volume=0.9:0.95:0.05", "-j", "2", "--set", "time.end=0.2", "-o", "all" };
  auto outcome = vesicle_command(folder.path(), command);
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  const auto rows = lines_of(bytes_of(folder / "all" / "sweep.csv"));
  ASSERT_EQ(rows.size(), 5u);
  expect_in(rows[0], "folder,flow.rate,vesicle.reduced_volume,state,step,time,dt,area");
  expect_in(rows[1], "rate=1_reduced_volume=0.9,1,0.9,finished,");
  expect_in(rows[4], "rate=2_reduced_volume=0.95,2,0.95,finished,");
  // The runs are those that `vesicle run` makes.
  ASSERT_EQ(
    run_pear(folder, "single",
      { "--set", "time.end=0.2", "--set", "flow.rate=2", "--set", "vesicle.reduced_volume=0.95" })
      .code,
    0);
  const fs::path last = folder / "all" / "rate=2_reduced_volume=0.95";
  EXPECT_TRUE(bytes_of(last / "pear.csv") == bytes_of(folder / "single" / "pear.csv"));
  // Again: what is done is left alone, what is missing is made.
  const fs::path first = folder / "all" / "rate=1_reduced_volume=0.9";
  const auto before = fs::last_write_time(last / "summary.json");
  const std::string table = bytes_of(first / "pear.csv");
  fs::remove_all(first);
  outcome = vesicle_command(folder.path(), command);
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  expect_in(outcome.output, "4 runs, 3 of them done");
  EXPECT_TRUE(bytes_of(first / "pear.csv") == table);
  EXPECT_EQ(fs::last_write_time(last / "summary.json"), before);
}

TEST(Sweep, FailedRunsAreToldAndTheOthersMade)
{
  const TemporaryFolder folder;
  write_scene_file(folder.path());
  const auto outcome = vesicle_command(folder.path(),
    { "sweep", "pear.toml", "--over", "flow.rate=500,1", "--set", "time.step=0.1", "-o", "all" });
  EXPECT_EQ(outcome.code, 3);
  expect_in(outcome.errors, "rate=500: ");
  const auto rows = lines_of(bytes_of(folder / "all" / "sweep.csv"));
  ASSERT_EQ(rows.size(), 3u);
  expect_in(rows[1], "rate=500,500,failed");
  expect_in(rows[2], "rate=1,1,finished");
}

TEST(Sweep, RefusesBeforeAnythingRuns)
{
  const TemporaryFolder folder;
  write_scene_file(folder.path());
  const auto outcome = vesicle_command(folder.path(),
    { "sweep", "pear.toml", "--over", "vesicle.reduced_volume=0.9,1.9", "-o", "all" });
  EXPECT_EQ(outcome.code, 2);
  expect_in(outcome.errors, "vesicle.reduced_volume=1.9");
  EXPECT_FALSE(fs::exists(folder / "all"));
  expect_usage_errors(folder.path(),
    { { "sweep", "pear.toml" }, { "sweep", "pear.toml", "--over", "flow.rate" },
      { "sweep", "pear.toml", "--over", "flow.rat=1,2" } });
}

TEST(Sweep, SlurmsJobsMakeTheSame)
{
  const TemporaryFolder folder;
  write_scene_file(folder.path());
  const std::vector<std::string> command{ "sweep", "pear.toml", "--over", "flow.rate=1,2", "--set",
    "time.end=0.1", "-o", "all", "--threads", "1" };
  auto with = [&](std::vector<std::string> more)
  {
    more.insert(more.begin(), command.begin(), command.end());
    return vesicle_command(folder.path(), more);
  };
  ASSERT_EQ(with({ "--slurm", "job.sh" }).code, 0);
  EXPECT_FALSE(fs::exists(folder / "all"));
  expect_in(bytes_of(folder / "job.sh"), "#SBATCH --array=0-1%1\n");
  for (const std::string task : { "0", "1" })
  {
    const auto outcome =
      program("/usr/bin/env", folder.path(), { "SLURM_ARRAY_TASK_ID=" + task, "bash", "job.sh" });
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
  }
  ASSERT_EQ(with({ "--table" }).code, 0);
  const auto rows = lines_of(bytes_of(folder / "all" / "sweep.csv"));
  ASSERT_EQ(rows.size(), 3u);
  expect_in(rows[2], "rate=2,2,finished,");
}

}
