// Every call by which a run changes its folder fails in turn, in every way; and damaged run files.

#include "tests/faults/DamagedRuns.h"
#include "tests/faults/FaultRuns.h"

#include <gtest/gtest.h>

#include <iostream>

namespace vesicle::test
{
namespace
{

void expect_nothing_lost_from(std::int64_t first, FaultRuns& runs)
{
  for (std::int64_t call = first; call <= runs.calls(); ++call)
  {
    for (Fault fault : kinds_of_faults())
    {
      fault.call = call;
      runs.expect_nothing_lost(fault);
    }
  }
  std::cout << text_of(runs.tally()) << '\n';
}

}

TEST(FaultsLong, OfAnyCallLoseNothing)
{
  FaultRuns runs({ "--no-movie", "--no-plots" });
  expect_nothing_lost_from(1, runs);
}

TEST(FaultsLong, OfAnyCallLoseNeitherPicturesNorFilm)
{
  const std::int64_t without = FaultRuns({ "--no-movie", "--no-plots" }).calls();
  constexpr std::int64_t last_calls = 5; // those after the pictures are made, and some
  FaultRuns runs({ "--no-plots" });
  expect_nothing_lost_from(without - last_calls, runs);
}

TEST(FaultsLong, AnyDamageToTheRunFileIsNoticed)
{
  expect_damage_to_be_noticed(600);
}

}
