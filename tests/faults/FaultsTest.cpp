// A sample of what FaultsLongTest.cpp tries.

#include "tests/faults/DamagedRuns.h"
#include "tests/faults/FaultRuns.h"

#include <gtest/gtest.h>

#include <iostream>

namespace vesicle::test
{

TEST(Faults, OfASampleOfCallsLoseNothing)
{
  FaultRuns runs({ "--no-movie", "--no-plots" });
  ASSERT_GT(runs.calls(), 50);
  constexpr std::int64_t stride = 53; // prime to the number of kinds: each meets all parts of a run
  const auto& kinds = kinds_of_faults();
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(kinds.size()) * runs.calls(); i += stride)
  {
    Fault fault = kinds[static_cast<std::size_t>(i) % kinds.size()];
    fault.call = 1 + i / static_cast<std::int64_t>(kinds.size());
    runs.expect_nothing_lost(fault);
  }
  std::cout << text_of(runs.tally()) << '\n';
}

TEST(Faults, ASampleOfDamagesToTheRunFileIsNoticed)
{
  expect_damage_to_be_noticed(20);
}

}
