// Limits of manufactured sequences: known limits and orders, with and without noise.

#include "apps/tradeoff/Extrapolation.h"
#include "solver/Errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace vesicle::tradeoff
{
namespace
{

constexpr Orders orders{ 0.5, 3 };

/// limit + c h^p (1 + noise z), h halved from 1 on.
std::vector<Sample> sequence(int count, double limit, double c, double p)
{
  std::vector<Sample> samples;
  for (int i = 0; i < count; ++i)
  {
    const double h = std::pow(2., -i);
    samples.push_back({ h, limit + c * std::pow(h, p) });
  }
  return samples;
}

}

TEST(Extrapolation, FindsLimitAndOrderOfACleanSequence)
{
  for (const double p : { 0.75, 1., 1.5, 2., 2.5 })
    for (const double c : { -0.3, 0.01 })
    {
      const Limit limit = extrapolate(sequence(5, 2.3, c, p), orders);
      const double finest = std::abs(c) * std::pow(2., -4 * p);
      EXPECT_LT(std::abs(limit.value - 2.3), 0.25 * finest) << p; // what may be irregular of it
      EXPECT_LT(std::abs(limit.value - 2.3), limit.uncertainty) << p;
      EXPECT_LT(limit.uncertainty, 2 * finest) << p;
      EXPECT_NEAR(limit.order, p, 0.25);
    }
}

TEST(Extrapolation, IsSureOfAKnownOrder)
{
  const Limit limit = extrapolate(sequence(3, 1, 0.1, 2), { 2, 2 });
  EXPECT_NEAR(limit.value, 1, 1e-12);
  EXPECT_EQ(limit.order, 2);
}

// Whatever unit h has, and whatever is added to the values or they are multiplied with.
TEST(Extrapolation, KnowsNoUnits)
{
  std::vector<Sample> samples{ { 1, 1.3 }, { 0.5, 1.08 }, { 0.25, 1.03 }, { 0.12, 1.004 } };
  const Limit limit = extrapolate(samples, orders);
  for (Sample& s : samples)
    s = { 1e6 * s.h, 1e-3 * s.value - 7 };
  const Limit other = extrapolate(samples, orders);
  EXPECT_NEAR(other.value, 1e-3 * limit.value - 7, 1e-12);
  EXPECT_NEAR(other.uncertainty, 1e-3 * limit.uncertainty, 1e-11);
  EXPECT_NEAR(other.order, limit.order, 1e-6);
}

// Irregular parts of no, a tenth of, and three times the leading error, orders anywhere in the range:
// the uncertainty holds the limit nine times of ten, from two samples on, and isn't idle.
TEST(Extrapolation, HoldsTheLimitNineTimesOfTen)
{
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> order(orders.lowest, orders.highest);
  constexpr int trials = 2000;
  for (const int count : { 2, 3, 4, 6 })
    for (const double noise : { 0., 0.1, 0.3, 1., 3. })
    {
      int held = 0;
      double useful = 0;
      for (int i = 0; i < trials; ++i)
      {
        const double p = order(random), c = 1e-3;
        std::vector<Sample> samples = sequence(count, 1, c, p);
        for (Sample& s : samples)
          s.value += noise * c * std::pow(s.h, p) * normal(random);
        const Limit limit = extrapolate(samples, orders);
        held += std::abs(limit.value - 1) <= limit.uncertainty;
        useful += limit.uncertainty < std::abs(samples.front().value - 1) ? 1 : 0;
      }
      EXPECT_GT(held, 0.9 * trials) << count << " samples, noise " << noise;
      if (count >= 4 && noise <= 1)
      {
        EXPECT_GT(useful, 0.6 * trials) << count << " samples, noise " << noise;
      }
    }
}

TEST(Extrapolation, TakesEqualResolutionsAsOne)
{
  auto samples = sequence(3, 1, 0.1, 2);
  const Limit limit = extrapolate(samples, orders);
  samples.push_back({ 0.5, samples[1].value + 1e-4 });
  samples.push_back({ 0.5, samples[1].value - 1e-4 });
  const Limit same = extrapolate(samples, orders);
  EXPECT_NEAR(same.value, limit.value, 1e-12);
  EXPECT_NEAR(same.uncertainty, limit.uncertainty, 1e-10);
}

TEST(Extrapolation, OfAConstantIsThatConstant)
{
  const Limit limit = extrapolate({ { 1, 4 }, { 0.5, 4 }, { 0.25, 4 } }, orders);
  EXPECT_EQ(limit.value, 4);
  EXPECT_EQ(limit.uncertainty, 0);
}

TEST(Extrapolation, RefusesWhatTellsNothing)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(extrapolate({}, orders), InputError);
  EXPECT_THROW(extrapolate({ { 1, 2 } }, orders), InputError);
  EXPECT_THROW(extrapolate({ { 1, 2 }, { 1, 3 } }, orders), InputError);
  EXPECT_THROW(extrapolate({ { 1, 2 }, { 0, 3 } }, orders), InputError);
  EXPECT_THROW(extrapolate({ { 1, 2 }, { 0.5, nan } }, orders), InputError);
  EXPECT_THROW(extrapolate({ { 1, 2 }, { 0.5, 3 } }, { 2, 1 }), InputError);
  EXPECT_THROW(extrapolate({ { 1, 2 }, { 0.5, 3 } }, { 0, 1 }), InputError);
}

}
