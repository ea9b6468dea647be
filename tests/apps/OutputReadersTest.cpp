// Other programs read what a run leaves behind: each script of readers/ is a test.

#include "Command.h"

#include <gtest/gtest.h>

namespace vesicle::test
{
namespace
{

constexpr int module_missing = 77;

/// One run for all scripts.
class OutputReaders : public testing::TestWithParam<const char*>
{
protected:
  static void SetUpTestSuite()
  {
    folder = new TemporaryFolder;
    write_scene_file(folder->path());
    run = vesicle_command(folder->path(),
      { "run", "pear.toml", "--no-movie", "--no-plots", "--quiet", "--set", "time.end=0.2" });
  }
  static void TearDownTestSuite() { delete folder; }

  inline static TemporaryFolder* folder = nullptr;
  inline static Outcome run;
};

}

TEST_P(OutputReaders, AreContent)
{
  ASSERT_EQ(run.code, 0) << run.errors;
  EXPECT_EQ(run.output, "");
  const auto outcome = python_file(folder->path(),
    std::filesystem::path(VESICLE_SOURCE_DIR) / "tests/apps/readers" /
      (std::string(GetParam()) + ".py"),
    { VESICLE_COMMAND });
  if (outcome.code == module_missing)
  {
    GTEST_SKIP() << outcome.errors;
  }
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
}

INSTANTIATE_TEST_SUITE_P(Scripts, OutputReaders,
  testing::Values("times", "finite", "meshio_frames", "meshio_series", "meshio_round_trip",
    "h5py_files", "vtk_readers"),
  [](const auto& test) { return std::string(test.param); });

}
