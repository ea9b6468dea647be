// Estimates and recommendations of runs whose exact value and errors are made up.

#include "apps/tradeoff/Estimates.h"
#include "apps/tradeoff/Grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace vesicle::tradeoff
{
namespace
{

using enum Scene::Preset;

constexpr double exact = 2.5;

/// An error of N^−1.5 and one of the steps' square; each tolerance has steps of its own.
Trial made_up(Scene::Preset preset, int triangles, double tolerance)
{
  Trial t({ preset, triangles, { false, tolerance }, "" });
  t.outcome = Trial::Outcome::finished;
  t.end = 3;
  t.steps = std::round(20 / std::cbrt(tolerance));
  t.cpu_seconds = 1e-3 * t.steps * triangles / (preset == fast ? 4 : 1);
  const double space = (preset == fast ? 30 : 2) * std::pow(triangles, -1.5), dt = t.end / t.steps,
               time = 0.3 * dt * dt;
  t.values["velocity_z"] = exact + space - time;
  t.scales["velocity_z"] = exact;
  t.space_estimate = 3 * space;
  t.time_estimate = 3 * time; // as for the limit in time
  return t;
}

std::vector<Trial> made_up_grid()
{
  std::vector<Trial> trials;
  for (const auto preset : { balanced, fast })
    for (const int n : { 80, 160, 320, 640 })
      for (const double tolerance : { 1e-2, 1e-3, 1e-4 })
        if (n < 640 || tolerance == 1e-3)
          trials.push_back(made_up(preset, n, tolerance));
  return trials;
}

double true_error(const Trial& trial)
{
  return std::abs(trial.values.at("velocity_z") / exact - 1);
}

}

TEST(TradeoffEstimates, FindTheValueThatSpaceAndTimeTendTo)
{
  const auto best = best_value(made_up_grid(), "velocity_z");
  ASSERT_TRUE(best);
  EXPECT_LT(std::abs(best->value - exact), best->uncertainty);
  EXPECT_LT(best->uncertainty / exact, 2e-4); // the finest run is off by 5e-5
  EXPECT_EQ(best->scale, exact);
  EXPECT_EQ(best->from.substr(0, 8), "balanced"); // whose errors are a fifteenth of the other's
}

// Runs of any settings: the promise is within a factor of 2 of the truth unless that is less than the
// best value is known to.
TEST(TradeoffEstimates, PromiseWhatIsTrue)
{
  const auto trials = made_up_grid();
  const BestValue best = *best_value(trials, "velocity_z");
  for (const Trial& t : trials)
  {
    const Estimate e = *estimate(t, "velocity_z", best);
    EXPECT_LT(true_error(t), 2 * e.promised()) << t.settings.label();
    if (e.error > 2 * e.uncertainty)
    {
      EXPECT_GT(true_error(t), e.promised() / 2) << t.settings.label();
    }
  }
}

TEST(TradeoffEstimates, RecommendTheCheapestThatKeepsTheTolerance)
{
  const auto trials = made_up_grid();
  const std::vector<Reference> references{ { "velocity_z", *best_value(trials, "velocity_z") } };
  for (const double tolerance : { 2e-2, 3e-3, 1e-3 })
  {
    const auto r = recommend(trials, references, tolerance);
    ASSERT_TRUE(r);
    EXPECT_TRUE(r->keeps_tolerance);
    EXPECT_LT(true_error(trials[r->trial]), tolerance);
    for (const Trial& t : trials)
    {
      const bool cheaper = t.cpu_seconds < trials[r->trial].cpu_seconds;
      EXPECT_TRUE(!cheaper || dependable_error(t, trials, references) > tolerance)
        << t.settings.label();
    }
  }
  const auto none = recommend(trials, references, 1e-9);
  ASSERT_TRUE(none);
  EXPECT_FALSE(none->keeps_tolerance);
  EXPECT_FALSE(recommend({}, references, 1e-3));
}

// Where errors in space and time cancel, a run is no better than finer ones.
TEST(TradeoffEstimates, DoNotCountOnLuck)
{
  auto trials = made_up_grid();
  Trial& lucky = trials.front();
  lucky.values["velocity_z"] = exact;
  lucky.cpu_seconds = 1e-6;
  const std::vector<Reference> references{ { "velocity_z",
    *best_value(made_up_grid(), "velocity_z") } };
  EXPECT_LT(promised_error(lucky, references), 2e-4); // no more than the limit's uncertainty
  EXPECT_GT(dependable_error(lucky, trials, references), 5e-4);
  EXPECT_NE(recommend(trials, references, 2e-4)->trial, 0U);
}

TEST(TradeoffEstimates, DoWithoutRunsThatFailed)
{
  auto trials = made_up_grid();
  for (Trial& t : trials)
    if (t.settings.preset == balanced || t.settings.triangles == 80)
      t.outcome = Trial::Outcome::failed;
  const auto best = best_value(trials, "velocity_z");
  ASSERT_TRUE(best);
  EXPECT_LT(std::abs(best->value - exact), best->uncertainty);
  EXPECT_EQ(best->from.substr(0, 4), "fast");
  EXPECT_FALSE(best_value(trials, "inclination_deg"));
  EXPECT_FALSE(best_value({}, "velocity_z"));
}

TEST(TradeoffEstimates, TellHowWellRunsForesawTheirErrors)
{
  const auto trials = made_up_grid();
  const std::vector<Reference> references{ { "velocity_z", *best_value(trials, "velocity_z") } };
  const Foresight f = foresight(trials, references);
  EXPECT_EQ(f.runs, static_cast<int>(trials.size()));
  EXPECT_NEAR(f.median, 0.13, 0.1); // a third of each, relative to 2.5, and they partly cancel
  EXPECT_GT(f.ordered, 0.8);
}

TEST(TradeoffEstimates, CountAnglesInRadians)
{
  Trial t;
  t.scales = { { "inclination_deg", 32 }, { "velocity_x", 3 }, { "velocity_z", 4 },
    { "tilt_deg", 0 }, { "area", 12 } };
  EXPECT_NEAR(scale_of("inclination_deg", t), 57.2957795, 1e-6);
  EXPECT_NEAR(scale_of("tilt_deg", t), 57.2957795, 1e-6);
  EXPECT_EQ(scale_of("velocity_x", t), 5);
  EXPECT_EQ(scale_of("area", t), 12);
  EXPECT_EQ(scale_of("missing", t), 1);
}

TEST(TradeoffEstimates, ScaleAVesiclesSpeedByItsOwn)
{
  Trial t;
  t.scales = { { "velocity_x", 30 }, { "velocity_x[1]", 3 }, { "velocity_z[1]", 4 },
    { "tilt_deg[1]", 1 } };
  EXPECT_EQ(scale_of("velocity_x", t), 30);
  EXPECT_EQ(scale_of("velocity_x[1]", t), 5);
  EXPECT_NEAR(scale_of("tilt_deg[1]", t), 57.2957795, 1e-6);
}

TEST(TradeoffGrid, HasTheScenesOwnSettingAndThePapersSchemeAndNothingTwice)
{
  const auto grid = settings_grid(640, { false, 1e-3 });
  std::set<std::string> labels;
  for (const Settings& s : grid)
    EXPECT_TRUE(labels.insert(s.label()).second) << s.label();
  EXPECT_TRUE(labels.contains("balanced-640-0.001"));
  EXPECT_TRUE(labels.contains("paper-160-0.001"));
  EXPECT_TRUE(labels.contains("balanced-160-0.001-quadrature-6"));
}

TEST(TradeoffGrid, RefinesFixedStepsAsTheSquareRootOfTheirError)
{
  std::set<double> steps;
  for (const Settings& s : settings_grid(640, { true, 0.1 }))
  {
    EXPECT_EQ(s.overrides()[2].substr(0, 10), "time.step=");
    steps.insert(s.time.value);
  }
  EXPECT_EQ(steps, (std::set<double>{ 0.025, 0.05, 0.1, 0.2 }));
}

TEST(TradeoffSettings, AreWhatTheyWouldBeInAScene)
{
  const Settings s{ balanced, 320, { false, 1e-3 }, "precision=double" };
  EXPECT_EQ(s.label(), "balanced-320-0.001-precision-double");
  EXPECT_EQ(s.toml(1),
    "[vesicle]\ntriangles = 320\n\n[time]\ntolerance = 0.001\n\n[accuracy]\n"
    "preset = \"balanced\"\nprecision = \"double\"\n");
  EXPECT_TRUE(s.toml(2).starts_with("# of each [[vesicle]]: triangles = 320\n\n[time]\n"));
}

}
