#include "apps/AreaStatistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace vesicle::test
{

TEST(AreaStatistics, EachValueCountsByItsArea)
{
  const AreaStatistics s = area_statistics({ 3, 1, 2 }, { 1, 2, 1 }, 4);
  EXPECT_DOUBLE_EQ(s.area, 4);
  EXPECT_DOUBLE_EQ(s.mean, (2 * 1 + 1 * 2 + 1 * 3) / 4.);
  EXPECT_DOUBLE_EQ(s.deviation, std::sqrt((2 * 0.5625 + 0.0625 + 1.5625) / 4));
  EXPECT_EQ(s.least, 1);
  EXPECT_EQ(s.greatest, 3);
  // 1 up to half of the area, then 2 up to three quarters.
  EXPECT_EQ(s.percentiles[3], 1);
  EXPECT_EQ(s.percentiles[4], 2);
  EXPECT_EQ(s.percentiles[5], 3);
  ASSERT_EQ(s.bins.size(), 4u);
  EXPECT_DOUBLE_EQ(s.bins[0].share, 0.5);
  EXPECT_DOUBLE_EQ(s.bins[2].share, 0.25);
  EXPECT_DOUBLE_EQ(s.bins[3].share, 0.25); // its end belongs to it
}

// Uniform values: mean 1/2, deviation 1/√12, percentiles themselves, the same in each bin.
TEST(AreaStatistics, OfManyAreTheDistributions)
{
  constexpr int count = 100'000;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<double> values(count), areas(count);
  for (int i = 0; i < count; ++i)
  {
    values[i] = uniform(random);
    areas[i] = 0.5 + uniform(random);
  }
  const AreaStatistics s = area_statistics(values, areas, 10);
  const double error = 4 / std::sqrt(count);
  EXPECT_NEAR(s.mean, 0.5, error);
  EXPECT_NEAR(s.deviation, 1 / std::sqrt(12), error);
  for (std::size_t i = 0; i < s.percents.size(); ++i)
  {
    EXPECT_NEAR(s.percentiles[i], s.percents[i] / 100., error);
  }
  double sum = 0;
  for (std::size_t i = 0; i < s.bins.size(); ++i)
  {
    sum += s.bins[i].share;
    const bool outermost = i == 0 || i + 1 == s.bins.size(); // with the 1% beyond
    EXPECT_NEAR(s.bins[i].share, outermost ? 0.108 : 0.098, error);
  }
  EXPECT_NEAR(sum, 1, 1e-12);
}

TEST(AreaStatistics, OneValueAndNone)
{
  const AreaStatistics one = area_statistics({ 2, 2 }, { 1, 1 }, 5);
  EXPECT_EQ(one.deviation, 0);
  ASSERT_EQ(one.bins.size(), 1u);
  EXPECT_EQ(one.bins[0].share, 1);
  EXPECT_EQ(area_statistics({}, {}, 5).area, 0);
}

}
