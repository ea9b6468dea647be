// A sample of what FaultsLongTest.cpp tries.

#include "tests/faults/DamagedRuns.h"
#include "tests/faults/FaultRuns.h"

#include <gtest/gtest.h>

#include <iostream>

namespace vesicle::test
{

namespace
{

/// Of all calls of a run, in all ways; `stride` is prime to the number of kinds, so that each meets
/// all parts of a run.
void expect_nothing_lost(FaultRuns& runs, std::int64_t stride)
{
  ASSERT_GT(runs.calls(), 50);
  const auto& kinds = kinds_of_faults();
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(kinds.size()) * runs.calls(); i += stride)
  {
    Fault fault = kinds[static_cast<std::size_t>(i) % kinds.size()];
    fault.call = 1 + i / static_cast<std::int64_t>(kinds.size());
    runs.expect_nothing_lost(fault);
  }
  std::cout << text_of(runs.tally()) << '\n';
}

}

TEST(Faults, OfASampleOfCallsLoseNothing)
{
  FaultRuns runs({ "--no-movie", "--no-plots" });
  expect_nothing_lost(runs, 53);
}

// Steps take a few milliseconds: the run is as far ahead of the disk as it may be.
TEST(Faults, OfADiskThatIsBehindLoseNothing)
{
  FaultRuns runs({ "--no-movie", "--no-plots" });
  runs.set_delay(std::chrono::milliseconds(10));
  expect_nothing_lost(runs, 109);
}

TEST(Faults, ASampleOfDamagesToTheRunFileIsNoticed)
{
  expect_damage_to_be_noticed(20);
}

}
