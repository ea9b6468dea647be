#include "apps/tradeoff/ParetoFront.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace vesicle::tradeoff
{

TEST(ParetoFront, LeavesOutWhatIsBeaten)
{
  const std::vector<Choice> choices{ { 4, 1 }, { 1, 8 }, { 2, 9 }, { 2, 3 }, { 4, 2 }, { 9, 0.5 } };
  EXPECT_EQ(pareto_front(choices), (std::vector<std::size_t>{ 1, 3, 0, 5 }));
}

TEST(ParetoFront, TakesTheFirstOfEqualsAndNothingThatIsNotFinite)
{
  EXPECT_EQ(pareto_front({ { 1, 1 }, { 1, 1 }, { 0, INFINITY }, { NAN, 0 } }),
    (std::vector<std::size_t>{ 0 }));
  EXPECT_TRUE(pareto_front({}).empty());
}

// By its definition, over all pairs.
TEST(ParetoFront, IsWhatNothingBeats)
{
  std::mt19937 random(3);
  std::uniform_int_distribution<int> digit(0, 9);
  for (int i = 0; i < 50; ++i)
  {
    std::vector<Choice> choices;
    for (int k = 0; k < 20; ++k)
      choices.push_back({ 1. * digit(random), 1. * digit(random) });
    const auto front = pareto_front(choices);
    for (std::size_t a = 0; a < choices.size(); ++a)
    {
      bool beaten = false;
      for (std::size_t b = 0; b < choices.size(); ++b)
      {
        const Choice &x = choices[a], &y = choices[b];
        const bool as_good = y.cost <= x.cost && y.error <= x.error;
        beaten = beaten || (as_good && (y.cost < x.cost || y.error < x.error || b < a));
      }
      EXPECT_EQ(std::ranges::find(front, a) == front.end(), beaten);
    }
  }
}

}
