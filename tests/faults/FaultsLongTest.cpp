// Every call by which a run changes its folder fails in turn, in every way; and damaged run files.

#include "tests/faults/DamagedRuns.h"
#include "tests/faults/FaultRuns.h"

#include <gtest/gtest.h>

#include <csignal>
#include <iostream>

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

TEST(FaultsLong, AnyDamageToTheRunFileIsNoticed)
{
  expect_damage_to_be_noticed(600);
}

}
