// Every call by which a run changes its folder fails in turn, in every way.

#include "tests/faults/FaultRuns.h"

#include <gtest/gtest.h>

#include <iostream>

namespace vesicle::test
{
namespace
{

void expect_nothing_lost_at_any_call(FaultRuns& runs)
{
  for (std::int64_t call = 1; call <= runs.calls(); ++call)
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
  expect_nothing_lost_at_any_call(runs);
}

TEST(FaultsLong, OfAnyCallLoseNeitherPicturesNorFilm)
{
  FaultRuns runs({});
  expect_nothing_lost_at_any_call(runs);
}

}
