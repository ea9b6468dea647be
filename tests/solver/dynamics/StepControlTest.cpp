#include "solver/dynamics/StepControl.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace vesicle
{
namespace
{

TEST(StepControl, AcceptsWhatIsWithinTheLimits)
{
  EXPECT_EQ(reason_to_reject({}, {}), "");
  StepReport report;
  report.error = 3.9e-3;
  EXPECT_EQ(reason_to_reject(report, {}), "");
}

TEST(StepControl, RejectsAndSaysWhy)
{
  const auto reason = [](auto change)
  {
    StepReport report;
    change(report);
    return reason_to_reject(report, {});
  };
  EXPECT_NE(reason([](StepReport& r) { r.finite = false; }).find("finite"), std::string::npos);
  EXPECT_NE(reason([](StepReport& r) { r.error = 4.1e-3; }).find("error"), std::string::npos);
  EXPECT_NE(reason([](StepReport& r) { r.displacement = 0.4; }).find("edges"), std::string::npos);
  EXPECT_NE(reason([](StepReport& r) { r.area_change = 3e-3; }).find("area"), std::string::npos);
  EXPECT_NE(
    reason([](StepReport& r) { r.volume_change = 3e-3; }).find("volume"), std::string::npos);
  EXPECT_NE(
    reason([](StepReport& r) { r.constraint_left = 1e-8; }).find("restored"), std::string::npos);
  EXPECT_NE(reason([](StepReport& r) { r.energy_rise = 2e-6; }).find("energy"), std::string::npos);
  EXPECT_NE(reason([](StepReport& r) { r.energy_jump = 0.3; }).find("30%"), std::string::npos);
  EXPECT_NE(reason([](StepReport& r) { r.error = std::nan(""); }), "");
}

TEST(StepControl, TheErrorEstimateIsOfSecondOrder)
{
  StepReport report;
  report.error = 4e-3; // four times the tolerance: half the step, less the safety
  EXPECT_DOUBLE_EQ(wanted_step(0.1, 0.1, report, {}), 0.9 * 0.05);
  report.error = 0;
  EXPECT_DOUBLE_EQ(wanted_step(0.1, 0.1, report, {}), 0.15);
  report.energy_rise = 0.9e-6;
  EXPECT_DOUBLE_EQ(wanted_step(0.1, 0.1, report, {}), 0.1);
}

TEST(StepControl, AStepCutShortForAnOutputTimeDoesNotHoldTheNextOnesBack)
{
  StepReport report;
  report.error = 1e-3 / 16; // of a quarter of the planned step: the whole has the tolerance
  EXPECT_DOUBLE_EQ(wanted_step(0.1, 0.4, report, {}), 0.9 * 0.4);
  report.error = 1e-9;
  EXPECT_DOUBLE_EQ(wanted_step(0.1, 0.4, report, {}), 1.5 * 0.4);
  report.error = 4e-3; // a short step that is too long all the same
  EXPECT_DOUBLE_EQ(wanted_step(0.1, 0.4, report, {}), 0.9 * 0.05);
}

TEST(StepControl, HitsTargetsExactlyWithoutATinyLastStep)
{
  double time = 0, dt = 0.3;
  int steps = 0;
  for (; time < 1; ++steps)
  {
    const double step = step_towards(dt, time, 1);
    EXPECT_GE(step, dt / 2 * (1 - 1e-6));
    EXPECT_LE(step, dt * (1 + 1e-6));
    time = step == 1 - time ? 1 : time + step;
  }
  EXPECT_EQ(time, 1);
  EXPECT_EQ(steps, 4);
}

}
}
