#include "solver/dynamics/OutputSchedule.h"

#include <gtest/gtest.h>

namespace vesicle
{
namespace
{

State at(double time, std::int64_t output)
{
  State state;
  state.step = 1;
  state.time = time;
  state.controller.output = output;
  return state;
}

TEST(OutputSchedule, GoesFromMultipleToMultipleAndToTheEnd)
{
  const OutputSchedule schedule(0.1, 0.25);
  EXPECT_EQ(schedule.next(at(0, 1)), 0.1);
  EXPECT_EQ(schedule.next(at(0.1, 2)), 0.2);
  EXPECT_EQ(schedule.next(at(0.2, 3)), 0.25);
  EXPECT_EQ(OutputSchedule(0, 2).next(at(0, 1)), 2.);
  EXPECT_EQ(OutputSchedule(0, {}).next(at(0, 1)), std::nullopt);
}

// 3 · 0.1 isn't 0.3 in binary.
TEST(OutputSchedule, MultiplesOfDecimalFractionsAreTheDecimalFractions)
{
  EXPECT_EQ(OutputSchedule(0.1, 1).next(at(0.2, 3)), 0.3);
}

TEST(OutputSchedule, CountsOnWhereAMultipleWasHit)
{
  const OutputSchedule schedule(0.1, 1);
  State state = at(0.3, 3);
  EXPECT_FALSE(schedule.due(state));
  schedule.pass(state);
  EXPECT_EQ(state.controller.output, 4);
  EXPECT_TRUE(schedule.due(state));
  state.time = 0.35;
  schedule.pass(state);
  EXPECT_EQ(state.controller.output, 4);
  EXPECT_FALSE(schedule.due(state));
  EXPECT_TRUE(schedule.due(State()));
}

TEST(OutputSchedule, StopsAtCornersWithoutAnOutput)
{
  const OutputSchedule schedule(1, 2.5,
    [](double t) {
      return t < 0.3 ? std::optional(0.3) : t < 2 ? std::optional(2.) : std::nullopt;
    });
  EXPECT_EQ(schedule.next_stop(at(0, 1)), 0.3);
  EXPECT_EQ(schedule.next(at(0, 1)), 1.);
  EXPECT_EQ(schedule.next_stop(at(0.3, 1)), 1.);
  EXPECT_EQ(schedule.next_stop(at(1, 2)), 2.);
  EXPECT_EQ(schedule.next_stop(at(2, 3)), 2.5);
  EXPECT_FALSE(schedule.due(at(0.3, 1)));
}

TEST(OutputSchedule, ListsTheTimesOfARun)
{
  const std::vector<double> times{ 0, 0.1, 0.2, 0.25 };
  EXPECT_EQ(OutputSchedule(0.1, 0.25).between(0, 0.25), times);
  const std::vector<double> later{ 0.15, 0.2, 0.3 };
  EXPECT_EQ(OutputSchedule(0.1, 0.3).between(0.15, 0.3), later);
  EXPECT_EQ(OutputSchedule(0, 1.).between(0, 1).size(), 2u);
}

}
}
