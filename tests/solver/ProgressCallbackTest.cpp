#include "solver/ProgressCallback.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <vector>

namespace vesicle::test
{

TEST(ProgressCallback, EveryCallIsMadeOnceAndTheShareRisesToOne)
{
  std::vector<int> calls(107, 0);
  std::vector<double> shares;
  parallel_for_in_parts(
    107, 10, [&](double share) { shares.push_back(share); }, [&](int i) { ++calls[i]; });
  EXPECT_EQ(calls, std::vector<int>(107, 1));
  ASSERT_EQ(shares.size(), 11U);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_EQ(shares.back(), 1);
}

TEST(ProgressCallback, APartHasItsOwnRange)
{
  double told = 0;
  const ProgressCallback half = part_of([&](double share) { told = share; }, 0.5, 0.75);
  half(0);
  EXPECT_EQ(told, 0.5);
  half(1);
  EXPECT_EQ(told, 0.75);
  EXPECT_FALSE(part_of({}, 0, 1)) << "nobody asks";
}

TEST(ProgressCallback, WhatItThrowsEndsTheWork)
{
  std::atomic<int> calls = 0;
  const auto stop = [](double) { throw std::runtime_error("stop"); };
  EXPECT_THROW(parallel_for_in_parts(1000, 10, stop, [&](int) { ++calls; }), std::runtime_error);
  EXPECT_EQ(calls, 10);
  parallel_for_in_parts(5, 10, {}, [&](int) { ++calls; });
  EXPECT_EQ(calls, 15) << "without anybody who asks";
}

}
