// What a run leaves doesn't depend on the wall clock, whatever that says.

#include "tests/faults/FaultRuns.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>

namespace vesicle::test
{
namespace
{

/// As of a run made before the clock was set back by a day.
void date_tomorrow(const std::filesystem::path& folder)
{
  const auto tomorrow = std::filesystem::file_time_type::clock::now() + std::chrono::hours(24);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
  {
    std::filesystem::last_write_time(entry.path(), tomorrow);
  }
}

}

TEST(Clock, SetBackDisturbsNeitherARunNorItsResumeNorItsLock)
{
  FaultRuns runs({ "--no-movie", "--no-plots" });
  runs.set_clock_back();
  const auto whole = runs.run("whole", {});
  EXPECT_EQ(whole.code, 0) << whole.errors;
  EXPECT_EQ(
    differences(files_in(runs.folder() / "whole"), runs.undisturbed()), std::vector<std::string>{});

  const Fault halfway{ runs.calls() * 2 / 3, "kill", false };
  ASSERT_EQ(runs.run("killed", halfway).code, 128 + SIGKILL);
  ASSERT_TRUE(std::filesystem::exists(runs.folder() / "killed" / "vesicle.lock"));
  date_tomorrow(runs.folder() / "killed");
  const auto gone_on = runs.run("killed", {}, { "--resume" });
  EXPECT_EQ(gone_on.code, 0) << gone_on.errors;
  EXPECT_EQ(differences(files_in(runs.folder() / "killed"), runs.undisturbed()),
    std::vector<std::string>{});
}

}
