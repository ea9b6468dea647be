#include "Command.h"

#include "solver/state/FrameFile.h"
#include "solver/state/RunFile.h"
#include "vtkfilters/Filters/SeriesFile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <regex>

#include <unistd.h>

namespace vesicle::test
{
namespace
{

class Resume : public testing::Test
{
protected:
  Resume() { write_scene_file(folder.path()); }

  /// Long enough to be interrupted.
  std::vector<std::string> arguments(const std::string& output, const std::string& extra = "") const
  {
    std::vector<std::string> words{ "run", "pear.toml", "--no-movie", "--no-plots", "--quiet", "-o",
      output, "--set", "vesicle.triangles=320", "--set", "time.end=2.0" };
    if (!extra.empty())
    {
      words.push_back(extra);
    }
    return words;
  }

  /// Sends the signal once the table has a number of rows; the exit code.
  int interrupt(const std::string& output, int signal, long rows) const
  {
    Command run(VESICLE_COMMAND, folder.path(), arguments(output));
    while (run.running() && rows_of(output) < rows)
    {
      usleep(1000);
    }
    run.signal(signal);
    return run.wait();
  }

  long rows_of(const std::string& output) const
  {
    const auto table = folder / (output + "/pear.csv");
    if (!std::filesystem::exists(table))
    {
      return 0;
    }
    const std::string text = bytes_of(table);
    return std::count(text.begin(), text.end(), '\n') - 1;
  }

  /// What the .xdmf file lists is there, as many frames as in the .pvd file or one less or more.
  void expect_valid_xdmf(const std::string& output) const
  {
    const std::string text = bytes_of(folder / (output + "/pear.xdmf"));
    const std::regex points(R"(<Geometry[^>]*><DataItem[^>]*>([^:]+):/points<)");
    std::size_t frames = 0;
    for (std::sregex_iterator match(text.begin(), text.end(), points), end; match != end; ++match)
    {
      EXPECT_EQ(read_frame_layout(folder / output / (*match)[1].str()).triangles, 320);
      ++frames;
    }
    EXPECT_NEAR(
      static_cast<double>(read_series(folder / (output + "/pear.pvd")).size()), frames, 1);
    EXPECT_TRUE(text.ends_with("</Xdmf>\n"));
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
    const auto count = [&](const std::string& output)
    {
      const std::filesystem::recursive_directory_iterator files(folder / output);
      return std::distance(begin(files), end(files));
    };
    EXPECT_EQ(count(a), count(b));
  }

  TemporaryFolder folder;
};

}

TEST_F(Resume, InterruptedKilledAndUninterruptedRunsAreTheSameToTheByte)
{
  ASSERT_EQ(vesicle_command(folder.path(), arguments("straight")).code, 0);

  EXPECT_EQ(interrupt("stopped", SIGINT, 10), 130);
  EXPECT_TRUE(std::filesystem::exists(folder / "stopped/summary.json"));
  EXPECT_LT(rows_of("stopped"), rows_of("straight"));
  auto outcome = vesicle_command(folder.path(), arguments("stopped", "--resume"));
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  expect_same_files("straight", "stopped");

  EXPECT_EQ(interrupt("killed", SIGKILL, 20), 128 + SIGKILL);
  expect_valid_xdmf("killed");
  outcome = vesicle_command(folder.path(), arguments("killed", "--resume"));
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  expect_same_files("straight", "killed");
}

TEST_F(Resume, AFinishedRunStaysAndCanGoFurther)
{
  ASSERT_EQ(vesicle_command(folder.path(), arguments("run")).code, 0);
  const auto table = bytes_of(folder / "run/pear.csv");
  ASSERT_EQ(vesicle_command(folder.path(), arguments("run", "--resume")).code, 0);
  EXPECT_EQ(bytes_of(folder / "run/pear.csv"), table);
  const auto further = vesicle_command(folder.path(),
    { "run", "pear.toml", "--no-movie", "--no-plots", "-o", "run", "--set", "vesicle.triangles=320",
      "--set", "time.end=2.2", "--resume" });
  EXPECT_EQ(further.code, 0) << further.errors;
  EXPECT_TRUE(bytes_of(folder / "run/pear.csv").starts_with(table));
  EXPECT_TRUE(std::filesystem::exists(folder / "run/frames/pear_000022.vtu"));
}

TEST_F(Resume, AnotherSceneIsRefused)
{
  const std::vector<std::string> base{ "run", "pear.toml", "--no-movie", "--no-plots", "-o", "run",
    "--set" };
  const auto run = [&](std::vector<std::string> extra)
  {
    auto words = base;
    words.insert(words.end(), extra.begin(), extra.end());
    return vesicle_command(folder.path(), words);
  };
  ASSERT_EQ(run({ "time.end=0.2" }).code, 0);
  const auto thicker = run({ "fluid.viscosity=2.0", "--resume" });
  EXPECT_EQ(thicker.code, 2);
  EXPECT_NE(thicker.errors.find("viscosity"), std::string::npos) << thicker.errors;
  EXPECT_EQ(run({ "time.end=0.1", "--resume" }).code, 2);
}

TEST_F(Resume, AnotherMeshIsRefused)
{
  std::ofstream(folder / "mesh.toml") << "name = \"mesh\"\n[vesicle]\nfile = \"mesh.vtu\"\n"
                                         "[membrane]\nbending_rigidity = 1.0\n"
                                         "[time]\nend = 0.1\noutput_every = 0.1\n";
  const auto make_mesh = [&](const char* reduced_volume, const char* triangles)
  {
    EXPECT_EQ(vesicle_command(folder.path(),
                { "shape", "prolate", "--reduced-volume", reduced_volume, "--triangles", triangles,
                  "-o", "mesh.vtu" })
                .code,
      0);
  };
  const std::vector<std::string> words{ "run", "mesh.toml", "--no-movie", "--no-plots", "--resume",
    "--set", "accuracy.preset=fast" };
  make_mesh("0.9", "320");
  ASSERT_EQ(vesicle_command(folder.path(), words).code, 0);
  const auto table = bytes_of(folder / "mesh/mesh.csv"), run = bytes_of(folder / "mesh/mesh.h5");
  for (const auto& [reduced_volume, triangles] :
    { std::pair("0.9", "500"), std::pair("0.9", "80"), std::pair("0.8", "320") })
  {
    make_mesh(reduced_volume, triangles);
    const auto outcome = vesicle_command(folder.path(), words);
    EXPECT_EQ(outcome.code, 2) << triangles << outcome.errors;
    EXPECT_NE(outcome.errors.find("bring the old mesh"), std::string::npos) << outcome.errors;
    EXPECT_EQ(bytes_of(folder / "mesh/mesh.csv"), table);
    EXPECT_EQ(bytes_of(folder / "mesh/mesh.h5"), run);
  }
}

TEST_F(Resume, ACheckpointOfAnotherVersionIsRefused)
{
  const std::vector<std::string> words{ "run", "pear.toml", "--no-movie", "--set", "time.end=0.1" };
  ASSERT_EQ(vesicle_command(folder.path(), words).code, 0);
  const auto file = folder / "pear/pear.h5";
  RunFile::Header header;
  State state;
  std::vector<std::optional<double>> row;
  {
    const RunFile run = RunFile::open(file);
    header = run.header();
    state = run.state();
    row = run.series().back();
  }
  const auto expect_refused = [&](const RunFile::Header& changed, const std::string& reason)
  {
    std::filesystem::remove(file);
    row.resize(changed.columns.size());
    RunFile::create(file, changed).append(state, row);
    auto again = words;
    again.push_back("--resume");
    const auto outcome = vesicle_command(folder.path(), again);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(
      outcome.errors.find("another version of the program, with " + reason), std::string::npos)
      << outcome.errors;
  };
  auto other_columns = header;
  other_columns.columns.pop_back();
  expect_refused(other_columns, "other columns");
  auto other_keys = header;
  other_keys.scene += "unknown = 1\n"; // in its last table
  expect_refused(other_keys, "other keys in its scene");
}

TEST_F(Resume, WithoutARunItStarts)
{
  const auto outcome = vesicle_command(folder.path(),
    { "run", "pear.toml", "--no-movie", "--no-plots", "--resume", "--set", "time.end=0.1" });
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
}

/// False also of one that has ended and that nobody has asked for its exit code.
bool is_alive(const std::string& process)
{
  std::ifstream status("/proc/" + process + "/stat");
  std::string number, name, state;
  return status >> number >> name >> state && state != "Z" && state != "X";
}

TEST_F(Resume, FfmpegEndsWithAKilledRunAndTheFilmIsMadeThen)
{
  std::filesystem::create_directory(folder / "bin");
  const auto ffmpeg = folder / "bin/ffmpeg", process = folder / "process";
  std::ofstream(ffmpeg) << "#!/bin/sh\nfor film; do :; done\necho half > \"$film\"\n"
                        << "echo $$ > " << process.string() << ".part\nmv " << process.string()
                        << ".part " << process.string() << "\nexec sleep 100\n";
  std::filesystem::permissions(ffmpeg, std::filesystem::perms::owner_all);
  const std::vector<std::string> words{ "run", "pear.toml", "--no-plots", "--set",
    "accuracy.preset=fast", "--set", "time.end=0.1" };
  const std::string path = std::getenv("PATH");
  setenv("PATH", ((folder / "bin").string() + ":" + path).c_str(), 1);
  {
    Command run(VESICLE_COMMAND, folder.path(), words);
    while (run.running() && !std::filesystem::exists(process))
    {
      usleep(1000);
    }
    run.signal(SIGKILL);
    run.wait();
  }
  setenv("PATH", path.c_str(), 1);
  if (!std::filesystem::exists(process))
  {
    GTEST_SKIP() << "nothing can draw here";
  }
  std::string number;
  std::ifstream(process) >> number;
  for (int i = 0; i < 5000 && is_alive(number); ++i)
  {
    usleep(1000);
  }
  EXPECT_FALSE(is_alive(number));
  EXPECT_TRUE(std::filesystem::exists(folder / "pear/pear.part.mp4"));

  auto again = words;
  again.push_back("--resume");
  const auto outcome = vesicle_command(folder.path(), again);
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_FALSE(std::filesystem::exists(folder / "pear/pear.part.mp4"));
  const bool told = bytes_of(folder / "pear/summary.json").find("no film") != std::string::npos;
  EXPECT_NE(std::filesystem::exists(folder / "pear/pear.mp4"), told);
}

TEST_F(Resume, ARunningRunIsLeftAlone)
{
  Command first(VESICLE_COMMAND, folder.path(), arguments("run"));
  while (first.running() && rows_of("run") < 2)
  {
    usleep(1000);
  }
  first.signal(SIGSTOP);
  for (const char* way : { "--resume", "--overwrite" })
  {
    const auto outcome = vesicle_command(folder.path(), arguments("run", way));
    EXPECT_EQ(outcome.code, 4) << way;
    EXPECT_NE(outcome.errors.find("locked by another run"), std::string::npos) << outcome.errors;
  }
  first.signal(SIGCONT);
  EXPECT_EQ(first.wait(), 0);
}

}
