#include "apps/tradeoff/Estimates.h"

#include "apps/tradeoff/Extrapolation.h"
#include "apps/tradeoff/Observables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace vesicle::tradeoff
{
namespace
{

constexpr Orders space_orders{ 0.5, 3 }, time_orders{ 0.5, 2 };
/// Fewer leave the order open.
constexpr std::size_t enough_samples = 3;
/// Of a mesh's error in space, what moves with the step.
constexpr double moved_share = 0.5;

using Family = std::vector<const Trial*>;

/// The finished runs of one method that have the observable, of a preset without other changes.
Family family_of(
  const std::vector<Trial>& trials, Scene::Preset preset, const std::string& observable)
{
  Family family;
  for (const Trial& t : trials)
    if (t.finished() && t.settings.preset == preset && t.settings.knob.empty() &&
      t.value(observable))
      family.push_back(&t);
  return family;
}

std::size_t different(const std::vector<Sample>& samples)
{
  std::set<double> h;
  for (const Sample& s : samples)
    h.insert(s.h);
  return h.size();
}

std::vector<Sample> over_triangles(
  const Family& family, const TimeSetting& time, const std::string& observable)
{
  std::vector<Sample> samples;
  for (const Trial* t : family)
    if (t->settings.time == time)
      samples.push_back({ 1. / t->settings.triangles, *t->value(observable) });
  return samples;
}

std::vector<Sample> over_steps(const Family& family, int triangles, const std::string& observable)
{
  std::vector<Sample> samples;
  for (const Trial* t : family)
    if (t->settings.triangles == triangles && t->time_estimate.value_or(0) > 0)
      samples.push_back({ *t->time_estimate, *t->value(observable) });
  return samples;
}

/// The time setting of the most numbers of triangles; of several the finest.
TimeSetting base_time(const Family& family, const std::string& observable)
{
  TimeSetting best;
  std::size_t most = 0;
  for (const Trial* t : family)
  {
    const TimeSetting& time = t->settings.time;
    const std::size_t count = different(over_triangles(family, time, observable));
    if (count > most || (count == most && time.value < best.value))
    {
      most = count;
      best = time;
    }
  }
  return best;
}

struct TimeCorrection
{
  double value = 0, uncertainty = 0;
  std::size_t steps = 0; ///< different ones
};

/// Other steps lead to other vertices, and to another error in space: a correction that is small beside that
/// error isn't trusted.
TimeCorrection trusted(const TimeCorrection& correction, double space_error)
{
  const double square = std::pow(correction.value, 2),
               trust = square > 0 ? square / (square + std::pow(moved_share * space_error, 2)) : 0;
  return { trust * correction.value,
    std::hypot(correction.uncertainty, (1 - trust) * correction.value), correction.steps };
}

/// What is left of the error in time at a setting: by the finest mesh of enough different time errors, or of
/// two. `space_limit` is that over the triangles at this setting.
TimeCorrection time_correction(
  const Family& family, const TimeSetting& time, const std::string& observable, double space_limit)
{
  const Trial* base = nullptr;
  std::size_t most = 0;
  const auto rank = [](std::size_t count, const Trial* t)
  { return std::pair(std::min(count, enough_samples), t ? t->settings.triangles : 0); };
  for (const Trial* t : family)
  {
    const std::size_t count = different(over_steps(family, t->settings.triangles, observable));
    if (t->settings.time == time && rank(count, t) > rank(most, base))
    {
      most = count;
      base = t;
    }
  }
  if (most < 2)
    return { 0, 0, most };
  const Limit limit =
    extrapolate(over_steps(family, base->settings.triangles, observable), time_orders);
  const double value = *base->value(observable);
  return trusted({ limit.value - value, limit.uncertainty, most }, std::abs(value - space_limit));
}

/// Of one preset; `samples` are the numbers of triangles that it rests on.
struct PresetsValue
{
  BestValue best;
  std::size_t samples;
};

std::optional<PresetsValue> presets_value(
  const std::vector<Trial>& trials, Scene::Preset preset, const std::string& observable)
{
  const Family family = family_of(trials, preset, observable);
  const TimeSetting time = base_time(family, observable);
  const std::vector<Sample> samples = over_triangles(family, time, observable);
  const std::size_t count = different(samples);
  if (count < 2)
    return std::nullopt;
  const Limit space = extrapolate(samples, space_orders);
  const TimeCorrection left = time_correction(family, time, observable, space.value);
  const Trial& finest =
    **std::ranges::max_element(family, {}, [](const Trial* t) { return t->settings.triangles; });
  BestValue best;
  best.value = space.value + left.value;
  best.uncertainty = std::hypot(space.uncertainty, left.uncertainty);
  best.scale = scale_of(observable, finest);
  best.order_in_triangles = space.order;
  best.from = fmt::format("{}, {} numbers of triangles to {}, time settings: {}",
    finest.settings.preset_name(), count, finest.settings.triangles, left.steps);
  return PresetsValue{ best, count };
}

bool no_coarser(const Settings& a, const Settings& b)
{
  return a.triangles >= b.triangles && a.time.value <= b.time.value;
}

}

double scale_of(const std::string& observable, const Trial& trial)
{
  const auto scale = [&](const std::string& name)
  {
    const auto found = trial.scales.find(name);
    return found == trial.scales.end() ? 0. : found->second;
  };
  const std::string column = column_of(observable), vesicle = observable.substr(column.size());
  double result = scale(observable);
  if (column.ends_with("_deg"))
    result = 180 / std::numbers::pi;
  else if (column.starts_with("velocity_"))
    result = std::hypot(
      scale("velocity_x" + vesicle), scale("velocity_y" + vesicle), scale("velocity_z" + vesicle));
  return result > 0 ? result : 1;
}

std::optional<BestValue> best_value(const std::vector<Trial>& trials, const std::string& observable)
{
  std::optional<PresetsValue> best;
  using enum Scene::Preset;
  for (const Scene::Preset preset : { balanced, accurate, fast, paper })
  {
    const auto value = presets_value(trials, preset, observable);
    const auto rank = [](const PresetsValue& v)
    { return std::pair(v.samples < enough_samples, v.best.uncertainty); };
    if (value && (!best || rank(*value) < rank(*best)))
      best = value;
  }
  return best ? std::optional(best->best) : std::nullopt;
}

double Estimate::promised() const
{
  return std::hypot(error, uncertainty);
}

std::optional<Estimate> estimate(
  const Trial& trial, const std::string& observable, const BestValue& best)
{
  const auto value = trial.value(observable);
  if (!trial.finished() || !value)
    return std::nullopt;
  return Estimate{ std::abs(*value - best.value) / best.scale, best.uncertainty / best.scale };
}

double promised_error(const Trial& trial, const std::vector<Reference>& references)
{
  double error = 0;
  for (const Reference& r : references)
  {
    const auto e = estimate(trial, r.observable, r.best);
    error = std::max(error, e ? e->promised() : std::numeric_limits<double>::infinity());
  }
  return error;
}

double dependable_error(
  const Trial& trial, const std::vector<Trial>& trials, const std::vector<Reference>& references)
{
  double error = promised_error(trial, references);
  for (const Trial& other : trials)
    if (other.finished() && other.settings.same_method(trial.settings) &&
      no_coarser(other.settings, trial.settings))
      error = std::max(error, promised_error(other, references));
  return error;
}

std::optional<Recommendation> recommend(
  const std::vector<Trial>& trials, const std::vector<Reference>& references, double tolerance)
{
  std::optional<Recommendation> cheapest, best;
  for (std::size_t i = 0; i < trials.size(); ++i)
  {
    const double error = dependable_error(trials[i], trials, references);
    if (error <= tolerance &&
      (!cheapest || trials[i].cpu_seconds < trials[cheapest->trial].cpu_seconds))
      cheapest = { i, true };
    if (std::isfinite(error) &&
      (!best || error < dependable_error(trials[best->trial], trials, references)))
      best = { i, false };
  }
  return cheapest ? cheapest : best;
}

Foresight foresight(const std::vector<Trial>& trials, const std::vector<Reference>& references)
{
  struct Pair
  {
    double estimate, error;
  };
  std::vector<Pair> pairs;
  std::vector<double> ratios;
  for (const Trial& t : trials)
  {
    const double error = promised_error(t, references),
                 own = t.space_estimate.value_or(0) + t.time_estimate.value_or(0);
    if (!std::isfinite(error) || !(own > 0))
      continue;
    pairs.push_back({ own, error });
    ratios.push_back(error / own);
  }
  if (ratios.empty())
    return {};
  std::ranges::sort(ratios);
  const auto quantile = [&](double share)
  { return ratios[static_cast<std::size_t>(share * static_cast<double>(ratios.size() - 1))]; };
  int ordered = 0, all = 0;
  for (const Pair& a : pairs)
    for (const Pair& b : pairs)
      if (a.estimate > b.estimate)
      {
        ++all;
        ordered += a.error > b.error;
      }
  return { static_cast<int>(ratios.size()), quantile(0.1), quantile(0.5), quantile(0.9),
    all > 0 ? static_cast<double>(ordered) / all : 1 };
}

}
