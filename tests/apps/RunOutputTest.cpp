#include "Command.h"

#include "vtkfilters/Filters/SeriesFile.h"
#include "vtkfilters/Filters/SeriesWriter.h"

#include "solver/dynamics/Blas.h"
#include "solver/dynamics/Diagnostics.h"

#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVesicleStepper.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace vesicle::test
{
namespace
{

/// One run for all tests of this file.
class RunOutput : public testing::Test
{
protected:
  static void SetUpTestSuite()
  {
    // Linear solves round as in this process.
    setenv("OPENBLAS_CORETYPE", blas_kernel().c_str(), 0);
    folder = new TemporaryFolder;
    write_scene_file(folder->path());
    outcome = vesicle_command(
      folder->path(), { "run", "pear.toml", "--threads", "1", "--set", "accuracy.preset=fast" });
  }
  static void TearDownTestSuite() { delete folder; }
  void SetUp() override { ASSERT_EQ(outcome.code, 0) << outcome.errors; }

  static std::filesystem::path file(const std::string& name) { return *folder / ("pear/" + name); }
  static std::vector<std::vector<std::string>> table()
  {
    std::istringstream text(bytes_of(file("pear.csv")));
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(text, line);)
    {
      rows.emplace_back();
      std::istringstream fields(line + ',');
      for (std::string field; std::getline(fields, field, ',');)
      {
        rows.back().push_back(field);
      }
    }
    return rows;
  }

  inline static TemporaryFolder* folder = nullptr;
  inline static Outcome outcome;
};

}

TEST_F(RunOutput, TableHasTheColumnsAndStartsWithTheStart)
{
  const auto rows = table();
  const auto& names = Diagnostics::names();
  ASSERT_GT(rows.size(), 2u);
  EXPECT_TRUE(std::equal(names.begin(), names.end(), rows[0].begin(), rows[0].end()));
  EXPECT_EQ(rows[1][0], "0");
  EXPECT_EQ(rows[1][1], "0");
  EXPECT_EQ(rows.back()[1], "0.5");
  for (const auto& row : rows)
  {
    EXPECT_EQ(row.size(), names.size());
  }
}

TEST_F(RunOutput, FramesAreAtOutputTimesAndInTheTable)
{
  const auto rows = table();
  for (const char* name : { "pear.pvd", "pear.vtu.series" })
  {
    const auto frames = read_series(file(name));
    ASSERT_EQ(frames.size(), 6u);
    for (std::size_t i = 0; i < frames.size(); ++i)
    {
      EXPECT_NEAR(frames[i].time, 0.1 * static_cast<double>(i), 1e-15);
      EXPECT_TRUE(std::any_of(rows.begin() + 1, rows.end(),
        [&](const auto& row) { return std::stod(row[1]) == frames[i].time; }));
      EXPECT_TRUE(std::filesystem::exists(frames[i].file));
    }
  }
}

TEST_F(RunOutput, SummaryTellsWhatHappened)
{
  const auto summary = nlohmann::json::parse(bytes_of(file("summary.json")));
  EXPECT_EQ(summary["outcome"], "finished");
  EXPECT_EQ(summary["frames"], 6);
  EXPECT_EQ(summary["final"]["time"], 0.5);
  EXPECT_LT(std::abs(summary["drifts"]["area"].get<double>()), 1e-9);
  for (const char* program : { "vesicle", "vtk", "eigen", "hdf5", "compiler", "blas_kernel" })
  {
    EXPECT_FALSE(summary["versions"][program].get<std::string>().empty());
  }
}

TEST_F(RunOutput, InfoReadsTheSeries)
{
  const auto report = vesicle_command(folder->path(), { "info", "pear/pear.pvd", "--json" });
  ASSERT_EQ(report.code, 0) << report.errors;
  const auto frames = nlohmann::json::parse(report.output);
  ASSERT_EQ(frames.size(), 6u);
  EXPECT_NEAR(frames[5]["reduced_volume"].get<double>(), 0.95, 1e-6);
}

TEST_F(RunOutput, MovieIsDrawnAndDrawnAgain)
{
  const auto summary = nlohmann::json::parse(bytes_of(file("summary.json")));
  if (!std::filesystem::exists(file("movie/frame_000000.png")))
  {
    GTEST_SKIP() << summary["movie"];
  }
  EXPECT_TRUE(std::filesystem::exists(file("movie/frame_000005.png")));
  const auto render = vesicle_command(folder->path(),
    { "render", "pear/pear.vtu.series", "-o", "pictures", "--color", "Tension", "--range", "-2",
      "2", "--size", "160x120" });
  EXPECT_EQ(render.code, 0) << render.errors;
  EXPECT_TRUE(std::filesystem::exists(*folder / "pictures/frame_000005.png"));
  EXPECT_EQ(
    vesicle_command(folder->path(), { "render", "pear/pear.pvd", "-o", "p", "--size", "wide" })
      .code,
    2);
  EXPECT_EQ(
    vesicle_command(folder->path(), { "render", "pear/pear.pvd", "-o", "p", "--color", "Beauty" })
      .code,
    2);
}

TEST_F(RunOutput, ASecondRunNeedsPermission)
{
  auto again = vesicle_command(folder->path(), { "run", "pear.toml", "--no-movie" });
  EXPECT_EQ(again.code, 2);
  EXPECT_NE(again.errors.find("--overwrite"), std::string::npos);
  std::filesystem::copy(
    *folder / "pear", *folder / "copy", std::filesystem::copy_options::recursive);
  std::ofstream(*folder / "copy/notes.txt") << "mine";
  again = vesicle_command(folder->path(),
    { "run", "pear.toml", "-o", "copy", "--overwrite", "--no-movie", "--set", "time.end=0.1" });
  EXPECT_EQ(again.code, 0) << again.errors;
  EXPECT_TRUE(std::filesystem::exists(*folder / "copy/notes.txt"));
  EXPECT_FALSE(std::filesystem::exists(*folder / "copy/frames/pear_000002.vtu"));
  EXPECT_FALSE(std::filesystem::exists(*folder / "copy/movie"));
}

// Who drives the filter doesn't matter.
TEST_F(RunOutput, FramesAreThoseOfTheFilterByteForByte)
{
  vtkNew<vtkVesicleStepper> stepper;
  stepper->SetSceneFileName((*folder / "pear.toml").c_str());
  stepper->AddOverride("accuracy.preset=fast");
  stepper->UpdateInformation();
  vtkInformation* info = stepper->GetOutputInformation(0);
  const int times = info->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
  ASSERT_EQ(times, 6);
  SeriesWriter writer(*folder / "again", "pear");
  for (int i = 0; i < times; ++i)
  {
    stepper->UpdateTimeStep(info->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS())[i]);
    writer.append(stepper->GetOutput(), stepper->GetStateTime());
  }
  const auto again = read_series(writer.pvd_file()), run = read_series(file("pear.pvd"));
  ASSERT_EQ(again.size(), run.size());
  for (std::size_t i = 0; i < run.size(); ++i)
  {
    EXPECT_EQ(again[i].time, run[i].time);
    EXPECT_TRUE(bytes_of(again[i].file) == bytes_of(run[i].file)) << run[i].file;
  }
}

}
