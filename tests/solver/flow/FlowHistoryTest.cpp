#include "solver/flow/FlowHistory.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vesicle
{
namespace
{

FlowHistory history(
  std::vector<std::array<double, 2>> table, std::optional<double> period = {}, double frequency = 0)
{
  return { std::move(table), period, frequency };
}

TEST(FlowHistory, WithoutATableIsSteady)
{
  const FlowHistory none;
  EXPECT_TRUE(none.steady());
  EXPECT_TRUE(none.settled(0));
  EXPECT_EQ(none.factor(3), 1);
  EXPECT_EQ(none.largest(), 1);
  EXPECT_EQ(none.next_corner(0), std::nullopt);
}

TEST(FlowHistory, IsLinearBetweenTimesAndConstantOutside)
{
  const FlowHistory ramp = history({ { 1, 2 }, { 3, -2 } });
  EXPECT_EQ(ramp.factor(0), 2);
  EXPECT_NEAR(ramp.factor(1.5), 1, 1e-9);
  EXPECT_NEAR(ramp.factor(2), 0, 1e-9);
  EXPECT_EQ(ramp.factor(7), -2);
  EXPECT_EQ(ramp.largest(), 2);
  EXPECT_EQ(ramp.next_corner(0), 1.);
  EXPECT_EQ(ramp.next_corner(1), 3.);
  EXPECT_EQ(ramp.next_corner(3), std::nullopt);
  EXPECT_FALSE(ramp.settled(2.9));
  EXPECT_TRUE(ramp.settled(3));
}

TEST(FlowHistory, AtAJumpWhatComesAfterItCounts)
{
  const FlowHistory stop = history({ { 0, 1 }, { 0.3, 1 }, { 0.3, 0 } });
  EXPECT_EQ(stop.factor(0.3 - 1e-9), 1);
  EXPECT_EQ(stop.factor(0.3), 0);
  EXPECT_EQ(stop.factor(0.1 + 0.2), 0); // not the same number
  EXPECT_EQ(stop.factor(3 * (0.3 / 7) * 7 / 3), 0);
}

// k periods and a row are hit up to rounding.
TEST(FlowHistory, RepeatsWithItsPeriod)
{
  const FlowHistory square = history({ { 0, 1 }, { 0.1, 1 }, { 0.1, -1 }, { 0.3, -1 } }, 0.3);
  double time = 0;
  for (int turn = 0; turn < 1000; ++turn)
  {
    EXPECT_EQ(square.factor(time), 1) << turn;
    time = *square.next_corner(time);
    EXPECT_NEAR(time, 0.3 * turn + 0.1, 1e-9 * (1 + turn));
    EXPECT_EQ(square.factor(time), -1) << turn;
    time = *square.next_corner(time);
    EXPECT_NEAR(time, 0.3 * (turn + 1), 1e-9 * (1 + turn));
  }
  EXPECT_FALSE(square.settled(1e6));
}

TEST(FlowHistory, OscillatesAsACosineThatMultipliesTheTable)
{
  const FlowHistory wave = history({ { 0, 2 }, { 1, 2 }, { 1, 1 } }, {}, 5);
  for (const double t : { 0., 0.2, 0.9 })
    EXPECT_NEAR(wave.factor(t), 2 * std::cos(5 * t), 1e-12);
  EXPECT_NEAR(wave.factor(4), std::cos(20.), 1e-12);
  EXPECT_FALSE(wave.settled(4));
  EXPECT_TRUE(wave.recurs());
}

TEST(FlowHistory, HasTheSameFactorsInOtherUnits)
{
  const FlowHistory wave = history({ { 0, 0 }, { 0.5, 1 }, { 0.5, 0.25 }, { 1, 0 } }, 1.25, 3);
  const double unit = 1e-3;
  const FlowHistory scaled = wave.in_units_of(unit);
  for (double t = 0; t < 5; t += 0.01)
    EXPECT_NEAR(scaled.factor(t / unit), wave.factor(t), 1e-8) << t;
}

}
}
