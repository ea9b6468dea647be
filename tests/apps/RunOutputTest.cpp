#include "Command.h"

#include "vtkfilters/Filters/SeriesFile.h"
#include "vtkfilters/Filters/SeriesWriter.h"

#include "solver/linear/Blas.h"
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
#include <utility>

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
  static std::vector<std::vector<std::string>> table(const std::string& run = "pear")
  {
    std::istringstream text(bytes_of(*folder / (run + "/pear.csv")));
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

// Frames hold the points to the last bit; only the unit of the curvature differs, in rounding.
TEST_F(RunOutput, InfoMeasuresTheSurfaceOfTheRun)
{
  for (const auto& [preset, basis] : { std::pair("balanced", "loop"), std::pair("fast", "linear") })
  {
    const std::string name(preset);
    const auto run = vesicle_command(folder->path(),
      { "run", "pear.toml", "-o", name, "--no-movie", "--no-plots", "--set",
        "accuracy.preset=" + name });
    ASSERT_EQ(run.code, 0) << run.errors;
    const auto info = vesicle_command(folder->path(), { "info", name + "/pear.pvd", "--json" });
    ASSERT_EQ(info.code, 0) << info.errors;
    const auto rows = table(name);
    const auto& names = rows[0];
    int compared = 0;
    for (const auto& frame : nlohmann::json::parse(info.output))
    {
      EXPECT_EQ(frame["basis"], basis);
      for (const auto& row : rows)
      {
        if (row == names || std::stod(row[1]) != frame["time"].get<double>())
        {
          continue;
        }
        ++compared;
        for (const char* quantity : { "area", "volume", "reduced_volume", "energy_over_8pi" })
        {
          const auto column = std::find(names.begin(), names.end(), quantity) - names.begin();
          EXPECT_NEAR(frame[quantity].get<double>(), std::stod(row[column]), 1e-11) << quantity;
        }
      }
    }
    EXPECT_EQ(compared, 6);
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

TEST_F(RunOutput, RenderTakesGuidesAndChartsFromTheRun)
{
  if (!std::filesystem::exists(file("movie/frame_000000.png")))
  {
    GTEST_SKIP() << "nothing can draw here";
  }
  const auto render = [](const std::vector<std::string>& options)
  {
    std::vector<std::string> arguments{ "render", "pear/pear.pvd", "--size", "320x180" };
    arguments.insert(arguments.end(), options.begin(), options.end());
    return vesicle_command(folder->path(), arguments);
  };
  auto outcome = render({ "-o", "chart", "--chart", "inclination", "--view", "front", "--smooth",
    "--arrows", "--edges", "--camera", "fixed", "--title", "Pear" });
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_EQ(outcome.errors, "");
  EXPECT_TRUE(std::filesystem::exists(*folder / "chart/frame_000005.png"));
  // The mesh alone has no table.
  outcome = vesicle_command(
    folder->path(), { "render", "pear/frames/pear_000000.vtu", "-o", "mesh", "--chart", "energy" });
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.errors.find("table"), std::string::npos) << outcome.errors;
  EXPECT_EQ(render({ "-o", "p", "--view", "above" }).code, 2);
  EXPECT_EQ(render({}).code, 2); // nothing to write
  EXPECT_EQ(render({ "--mp4", "film.mp4" }).code, 2);
  // A format is what its ending says.
  EXPECT_EQ(render({ "-o", "p", "--mp4", "film.gif" }).code, 2);
  EXPECT_EQ(render({ "--montage", "figure.pdf" }).code, 2);
  EXPECT_FALSE(std::filesystem::exists(*folder / "film.gif"));
}

TEST_F(RunOutput, ModelsAreForOtherPrograms)
{
  const auto render = [](const std::vector<std::string>& options)
  {
    std::vector<std::string> arguments{ "render", "pear/pear.pvd" };
    arguments.insert(arguments.end(), options.begin(), options.end());
    return vesicle_command(folder->path(), arguments);
  };
  auto outcome = render({ "--model", "pear.gltf", "--smooth" });
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_EQ(nlohmann::json::parse(bytes_of(*folder / "pear.gltf"))["asset"]["version"], "2.0");
  outcome = render({ "--model", "pear.usda", "--times", "0", "0.1" });
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_NE(bytes_of(*folder / "pear.usda").find("endTimeCode = 1\n"), std::string::npos);
  EXPECT_EQ(render({ "--model", "pear.obj" }).code, 2);
  outcome = render({ "--model", "one.gltf", "--range", "1", "1" });
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.errors.find("not an interval"), std::string::npos) << outcome.errors;
}

TEST_F(RunOutput, MontageShowsShapesAtTheirTimes)
{
  if (!std::filesystem::exists(file("movie/frame_000000.png")))
  {
    GTEST_SKIP() << "nothing can draw here";
  }
  const auto montage = [](const std::vector<std::string>& options)
  {
    std::vector<std::string> arguments{ "render", "pear/pear.pvd", "--montage", "figure.png" };
    arguments.insert(arguments.end(), options.begin(), options.end());
    return vesicle_command(folder->path(), arguments);
  };
  EXPECT_EQ(montage({}).code, 0);
  const auto three = bytes_of(*folder / "figure.png");
  EXPECT_EQ(montage({ "--times", "0", "0.21", "0.5" }).code, 0);
  EXPECT_EQ(montage({ "--panels", "2", "--size", "400x200" }).code, 0);
  EXPECT_NE(bytes_of(*folder / "figure.png"), three);
  EXPECT_EQ(montage({ "--panels", "0" }).code, 2);
  EXPECT_EQ(montage({ "--size", "20x16", "--panels", "6" }).code, 2);
  EXPECT_EQ(vesicle_command(
              folder->path(), { "render", "pear/pear.pvd", "--montage", "nowhere/figure.png" })
              .code,
    4);
}

TEST_F(RunOutput, APageIsOneFileOrSaysWhatTheBuildLacks)
{
  const auto outcome =
    vesicle_command(folder->path(), { "render", "pear/pear.pvd", "--html", "page.html" });
  if (!std::filesystem::exists(VESICLE_BINARY_DIR "/share/vesicle/vtk.js"))
  {
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.errors.find("-DVESICLE_HTML=ON"), std::string::npos) << outcome.errors;
    return;
  }
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  const std::string page = bytes_of(*folder / "page.html");
  // Nothing is fetched: no element with a source or a link, and every mark was replaced.
  const std::string before = page.substr(0, page.find("<script"));
  EXPECT_EQ(before.find("src="), std::string::npos);
  EXPECT_EQ(before.find("href="), std::string::npos);
  for (const char* mark : { "@DATA@", "@VTK_JS@", "@PAGE_JS@", "@LICENSE@", "<script src" })
  {
    EXPECT_EQ(page.find(mark), std::string::npos) << mark;
  }
  const std::string begin = "<script type=\"application/json\" id=\"data\">";
  const std::size_t from = page.find(begin) + begin.size();
  const auto data = nlohmann::json::parse(page.substr(from, page.find("</script>", from) - from));
  ASSERT_EQ(data["frames"].size(), 6u);
  EXPECT_EQ(data["triangles"].size(), 1u); // shared by all frames
  // 42 points of three floats, in base64; 80 triangles.
  EXPECT_EQ(data["frames"][5]["points"].get<std::string>().size(), 42u * 3 * 4 / 3 * 4);
  EXPECT_EQ(data["triangles"][0].get<std::string>().size(), 80u * 3 * 4 / 3 * 4);
  EXPECT_EQ(data["frames"][2]["label"], "t = 0.2");
  EXPECT_EQ(data["table"]["columns"][1], "time");
  EXPECT_EQ(data["table"]["values"][1].back(), 0.5);
  EXPECT_EQ(data["table"]["chosen"], nlohmann::json::array({ "inclination_deg" }));
  for (const auto& array : data["arrays"])
  {
    EXPECT_EQ(array["frames"].size(), 6u);
    EXPECT_LE(array["extent"][0], array["extent"][1]);
  }
}

TEST_F(RunOutput, ABrokenTableIsNamedWithItsLine)
{
  std::filesystem::copy(
    *folder / "pear", *folder / "broken", std::filesystem::copy_options::recursive);
  std::ofstream(*folder / "broken/pear.csv", std::ios::app) << "1,two\n";
  const auto lines = table().size();
  const auto outcome = vesicle_command(
    folder->path(), { "render", "broken/pear.pvd", "-o", "p", "--chart", "energy" });
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.errors.find("pear.csv:" + std::to_string(lines + 1)), std::string::npos)
    << outcome.errors;
}

TEST_F(RunOutput, PlotsDoNotNeedAMovie)
{
  const auto run = [](const std::string& name, const std::string& option)
  {
    return vesicle_command(folder->path(),
      { "run", "pear.toml", "-o", name, "--no-movie", option, "--set", "time.end=0.1", "--set",
        "accuracy.preset=fast" });
  };
  if (!std::filesystem::exists(file("movie/frame_000000.png")))
  {
    GTEST_SKIP() << "nothing can draw here";
  }
  EXPECT_EQ(run("plots", "--quiet").code, 0);
  EXPECT_TRUE(std::filesystem::exists(*folder / "plots/plots/energy.png"));
  EXPECT_TRUE(std::filesystem::exists(*folder / "plots/plots/inclination.png"));
  EXPECT_FALSE(std::filesystem::exists(*folder / "plots/movie"));
  EXPECT_EQ(run("none", "--no-plots").code, 0);
  EXPECT_FALSE(std::filesystem::exists(*folder / "none/plots"));
}

TEST_F(RunOutput, ASecondRunNeedsPermission)
{
  auto again = vesicle_command(folder->path(), { "run", "pear.toml", "--no-movie", "--no-plots" });
  EXPECT_EQ(again.code, 2);
  EXPECT_NE(again.errors.find("--overwrite"), std::string::npos);
  std::filesystem::copy(
    *folder / "pear", *folder / "copy", std::filesystem::copy_options::recursive);
  std::ofstream(*folder / "copy/notes.txt") << "mine";
  again = vesicle_command(folder->path(),
    { "run", "pear.toml", "-o", "copy", "--overwrite", "--no-movie", "--no-plots", "--set",
      "time.end=0.1" });
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
