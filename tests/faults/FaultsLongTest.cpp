// Every call by which a run changes its folder fails in turn, in every way; and damaged run files.

#include "tests/faults/DamagedRuns.h"
#include "tests/faults/FaultRuns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <iostream>
#include <random>

namespace vesicle::test
{
namespace
{

/// From the call `first` to `last`, of a run or of going on with the one in the folder `from`.
void expect_nothing_lost(
  FaultRuns& runs, std::int64_t first, std::int64_t last, const std::string& from = {})
{
  for (std::int64_t call = first; call <= last; ++call)
  {
    for (Fault fault : kinds_of_faults())
    {
      fault.call = call;
      runs.expect_nothing_lost(fault, from);
    }
  }
  std::cout << text_of(runs.tally()) << '\n';
}

}

TEST(FaultsLong, OfAnyCallLoseNothing)
{
  FaultRuns runs({ "--no-movie", "--no-plots" });
  expect_nothing_lost(runs, 1, runs.calls());
}

TEST(FaultsLong, OfAnyCallLoseNeitherPicturesNorFilm)
{
  const std::int64_t without = FaultRuns({ "--no-movie", "--no-plots" }).calls();
  constexpr std::int64_t last_calls = 5; // those after the pictures are made, and some
  FaultRuns runs({ "--no-plots" });
  expect_nothing_lost(runs, without - last_calls, runs.calls());
}

TEST(FaultsLong, OfAnyCallOfAResumedRunLoseNothing)
{
  FaultRuns runs({ "--no-movie", "--no-plots" });
  const Fault halfway{ runs.calls() * 2 / 3, "kill", false };
  ASSERT_EQ(runs.run("halfway", halfway).code, 128 + SIGKILL);
  std::filesystem::copy(
    runs.folder() / "halfway", runs.folder() / "undone", std::filesystem::copy_options::recursive);
  ASSERT_EQ(runs.run("undone", {}, { "--resume" }).code, 0);
  expect_nothing_lost(runs, 1, runs.last_calls(), "halfway");
}

// Killed at any call, --overwrite leaves the old run or one that --resume goes on with.
TEST(FaultsLong, WhileARunIsReplacedOneOfTheTwoIsThere)
{
  FaultRuns runs({ "--no-movie", "--no-plots" });
  ASSERT_EQ(runs.run("old", {}, { "--set", "flow.rate=2.0" }).code, 0);
  const auto old = runs.folder() / "old", replaced = runs.folder() / "replaced";
  int kept = 0;
  for (std::int64_t call = 1; call <= runs.calls(); ++call)
  {
    SCOPED_TRACE("killed at call " + std::to_string(call));
    std::filesystem::remove_all(replaced);
    std::filesystem::copy(old, replaced, std::filesystem::copy_options::recursive);
    runs.run("replaced", { call, "kill", false }, { "--overwrite" });
    const auto resumed = runs.run("replaced", {}, { "--resume" });
    std::filesystem::remove(replaced / "pear.part.h5"); // a refusal sweeps nothing
    const bool is_old = resumed.code == 2;
    kept += is_old;
    ASSERT_TRUE(is_old || resumed.code == 0) << resumed.errors;
    EXPECT_EQ(differences(files_in(replaced), is_old ? files_in(old) : runs.undisturbed()),
      std::vector<std::string>{});
  }
  EXPECT_GT(kept, 0);
  EXPECT_LT(kept, runs.calls() / 2);
}

// A run and what goes on with it, each killed at any call, until one gets to the end.
TEST(FaultsLong, AThousandKillsInARowLoseNothing)
{
  FaultRuns runs({ "--no-movie", "--no-plots" });
  const auto folder = runs.folder() / "killed";
  std::mt19937_64 random(1);
  constexpr int enough = 1000;
  int kills = 0, finished = 0, most = 0;
  for (; kills < enough; ++finished)
  {
    std::filesystem::remove_all(folder);
    std::vector<std::string> way;
    int code = 128 + SIGKILL, of_this_run = 0;
    for (; code == 128 + SIGKILL; way = { "--resume" })
    {
      const auto call = static_cast<std::int64_t>(1 + random() % runs.calls());
      const auto outcome = runs.run("killed", { call, "kill", false }, way);
      code = outcome.code;
      of_this_run += code == 128 + SIGKILL;
      ASSERT_TRUE(code == 0 || code == 128 + SIGKILL) << kills << " kills: " << outcome.errors;
    }
    kills += of_this_run;
    most = std::max(most, of_this_run);
    EXPECT_EQ(differences(files_in(folder), runs.undisturbed()), std::vector<std::string>{});
  }
  std::cout << kills << " kills of " << finished << " runs, up to " << most << " of one\n";
}

TEST(FaultsLong, AnyDamageToTheRunFileIsNoticed)
{
  expect_damage_to_be_noticed(600);
}

}
