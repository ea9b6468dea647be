#include "solver/dynamics/Evolution.h"

#include "solver/Errors.h"
#include "solver/dynamics/StepFailure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vesicle
{

namespace
{

// The first step of an adaptive run, in units of the system's own time; the controller takes over.
constexpr double first_step = 1e-2;
// Where the system has no rate of its own (nothing moves, or nothing but a uniform flow).
constexpr double idle_rate = 1;
// Shorter steps than this fraction of the system's time mean that the run is stuck.
constexpr double shortest_step = 1e-6;
constexpr int max_attempts = 40;
// The shape's normal speed relative to its centroid, in r0 times the system's rate.
constexpr double steady_speed = 2e-3;

StepperSettings with_time_unit(StepperSettings settings, double time_unit)
{
  settings.time_unit = time_unit;
  return settings;
}

std::string contact_message(double time, const std::string& contact)
{
  return fmt::format("t = {}: {}", time, contact);
}

// The last guard: nothing else is ever saved.
void require_finite(const State& state)
{
  for (const VesicleState& v : state.vesicles)
    if (!v.points.allFinite() || !v.velocity.allFinite() || !v.node_velocity.allFinite() ||
      !v.tension.allFinite() || !v.stiff_force.allFinite())
      throw NumericalError("velocities or tensions are not finite");
}

}

Evolution::Evolution(System system, const StepperSettings& settings, const OutputSchedule& schedule,
  double time_unit, std::optional<double> fixed_step)
  : stepper_(std::move(system), with_time_unit(settings, time_unit)), schedule_(schedule),
    fixed_step_(fixed_step)
{
}

double Evolution::rate() const
{
  const double rate = stepper_.system().rate();
  return rate > 0 ? rate : idle_rate;
}

// next_step from free_step: no longer than the mesh allows, and such that the next output is hit.
void Evolution::plan_next_step(State& state)
{
  double dt = state.controller.free_step;
  const bool solved = std::all_of(state.vesicles.begin(), state.vesicles.end(),
    [](const VesicleState& vesicle) { return vesicle.velocity.rows() > 0; });
  if (!fixed_step_ && solved)
    dt = std::min(dt, stepper_.longest_step(state));
  if (const auto target = schedule_.next_stop(state); target && *target > state.time)
    dt = step_towards(dt, state.time / time_unit(), *target / time_unit());
  state.controller.next_step = dt;
}

// True for the last state of a run whose end has been put off since.
bool Evolution::overshoots(const State& state) const
{
  const auto target = schedule_.next_stop(state);
  return target && state.controller.next_step > (*target - state.time) / time_unit() * (1 + 1e-9);
}

bool Evolution::steady(const State& state)
{
  if (system().flow && !system().flow->settled(state.time / time_unit()))
    return false;
  const auto shape = stepper_.shape(state);
  return largest_normal(*shape, relative_to_centroids(*shape, velocity_of(state))) <
    steady_speed * rate();
}

State Evolution::unsolved(const std::vector<Points>& points)
{
  State state;
  for (std::size_t v = 0; v < points.size(); ++v)
  {
    VesicleState& vesicle = state.vesicles.emplace_back();
    vesicle.triangles = system().vesicles[v].space->triangles();
    vesicle.points = points[v];
  }
  state.preconditioner.points.resize(points.size());
  const auto shape = stepper_.shape(state);
  for (std::size_t v = 0; v < points.size(); ++v)
  {
    state.vesicles[v].target_area = shape->vesicles[v].surface->area;
    state.vesicles[v].target_volume = shape->vesicles[v].surface->volume;
  }
  return state;
}

void Evolution::require_apart(const State& state)
{
  try
  {
    stepper_.require_apart(state);
  }
  catch (const NumericalError& contact)
  {
    throw NumericalError(contact_message(state.time, contact.what()));
  }
}

State Evolution::instant(const std::vector<Points>& points)
{
  State state = unsolved(points);
  stepper_.solve(state); // over a step of 0
  return state;
}

State Evolution::start(const std::vector<Points>& points)
{
  State state = unsolved(points);
  require_apart(state);
  state.controller.free_step = fixed_step_.value_or(first_step / rate());
  plan_next_step(state);
  stepper_.solve(state);
  return state;
}

State Evolution::transferred(const State& before, const std::vector<Points>& points)
{
  State state = unsolved(points);
  state.step = before.step;
  state.time = before.time;
  state.iterations = before.iterations;
  state.controller = before.controller;
  state.remeshing = before.remeshing;
  for (std::size_t v = 0; v < points.size(); ++v)
  {
    state.vesicles[v].target_area = before.vesicles[v].target_area;
    state.vesicles[v].target_volume = before.vesicles[v].target_volume;
    state.vesicles[v].area_correction = before.vesicles[v].area_correction;
    state.vesicles[v].volume_correction = before.vesicles[v].volume_correction;
  }
  plan_next_step(state);
  stepper_.solve(state);
  require_finite(state);
  return state;
}

State Evolution::step(const State& before)
{
  State from = before;
  if (overshoots(from))
  {
    plan_next_step(from);
    stepper_.solve(from);
  }
  std::string reason;
  std::shared_ptr<const State> refused;
  for (int attempt = 0; attempt < max_attempts; ++attempt)
  {
    try
    {
      StepReport report;
      State after = stepper_.attempt(from, report);
      reason = reason_to_reject(report, stepper_.settings().limits);
      if (reason.empty() && report.contact.empty())
        return accept(before, from, std::move(after), report);
      refused = std::make_shared<const State>(std::move(after));
      if (reason.empty()) // shorter steps come there as well
        throw StepFailure(contact_message(before.time, report.contact), refused);
    }
    catch (const StepFailure&)
    {
      throw;
    }
    catch (const NumericalError& error)
    {
      reason = error.what(); // of a solve, this step's or the next one's start
    }
    if (fixed_step_)
      throw StepFailure(
        fmt::format(
          "t = {}: a step of {} can't be made: {}. Take a smaller time.step, or time.step = "
          "\"auto\".",
          before.time, from.controller.next_step * time_unit(), reason),
        refused);
    ++from.controller.rejected;
    from.controller.free_step = from.controller.next_step / 2;
    if (from.controller.free_step < shortest_step / rate())
      break;
    plan_next_step(from);
    stepper_.solve(from);
  }
  throw StepFailure(
    fmt::format("t = {}: no step can be made, down to {:.1e}: {}. Try more triangles, or "
                "a milder flow, load or deflation.",
      before.time, from.controller.next_step * time_unit(), reason),
    refused);
}

// `from`: the start of the step, planned anew after rejections.
State Evolution::accept(const State& before, const State& from, State after, StepReport report)
{
  const auto target = schedule_.next_stop(before);
  const double dt = from.controller.next_step;
  const bool on_target = target && dt == *target / time_unit() - before.time / time_unit();
  if (on_target)
    after.time = *target;
  schedule_.pass(after);
  const auto choose_step = [&]
  {
    if (!fixed_step_)
      after.controller.free_step =
        wanted_step(dt, from.controller.free_step, report, stepper_.settings().limits);
  };
  choose_step();
  plan_next_step(after);
  stepper_.solve(after);
  // An error that is known only now counts for the step after the next one.
  stepper_.complete(from, after, report);
  choose_step();
  require_finite(after);
  return after;
}

}
