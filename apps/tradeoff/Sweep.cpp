#include "apps/tradeoff/Sweep.h"

#include "apps/Commands.h"
#include "apps/Interrupt.h"
#include "apps/Progress.h"
#include "apps/tradeoff/Grid.h"

#include "solver/Errors.h"
#include "solver/files/FileBytes.h"
#include "solver/scene/SceneFile.h"
#include "solver/simulation/Cost.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

namespace vesicle::tradeoff
{
namespace
{

constexpr auto look_every = std::chrono::milliseconds(20);
/// Where no run has told yet.
constexpr double unknown_steps = 100;
/// A run that takes so many times what is expected of it crawls: its shape asks for ever shorter steps.
constexpr double most_patience = 10;
constexpr double least_patience = 5; ///< seconds of CPU time

Scene scene_with_end(const SweepPlan& plan)
{
  std::vector<std::string> overrides = plan.overrides;
  overrides.push_back("accuracy.preset=balanced");
  Scene scene = read_scene(plan.scene, overrides);
  if (!scene.time.end)
    throw InputError(
      fmt::format("{}: key 'time.end': a trade-off compares runs at one time; give it by --end",
        plan.scene.string()));
  return scene;
}

/// How little one run tells of another's steps: the time setting decides, then the method.
double distance(const Settings& a, const Settings& b)
{
  return 100 * std::abs(std::log(a.time.value / b.time.value)) + (a.preset != b.preset ? 10 : 0) +
    std::abs(std::log2(static_cast<double>(a.triangles) / b.triangles));
}

}

Sweep::Sweep(SweepPlan plan, std::function<void(const std::string&)> tell)
  : plan_(std::move(plan)), tell_(std::move(tell)), folder_(plan_.folder),
    scene_(scene_with_end(plan_)), time_{ scene_.time.step.has_value(),
      scene_.time.step.value_or(scene_.time.tolerance) },
    memory_(resources_for(plan_.folder).memory)
{
}

void Sweep::run()
{
  make_folder(folder_.folder());
  std::vector<Settings> first = settings_grid(most_triangles, time_);
  std::erase_if(first,
    [](const Settings& s)
    { return s.preset != Scene::Preset::balanced || s.triangles != least_triangles; });
  add(first);
  if (const auto order = waiting(); !order.empty())
  {
    tell_(fmt::format("first {} runs of {} triangles, which tell how many steps there are",
      order.size(), least_triangles));
    carry_out(order);
  }
  if (interrupted())
    return;
  add(settings_grid(affordable_triangles(), time_));
  tell_plan();
  carry_out(waiting());
}

Trial Sweep::trial_of(const Settings& settings) const
{
  Trial trial(settings);
  std::vector<std::string> overrides = plan_.overrides;
  for (const std::string& override : settings.overrides())
    overrides.push_back(override);
  try
  {
    trial.scene = read_scene(plan_.scene, overrides);
  }
  catch (const InputError& error)
  {
    trial.outcome = Trial::Outcome::refused;
    trial.message = error.what();
  }
  return trial;
}

/// Those that aren't there yet, with what an earlier sitting left of them.
void Sweep::add(const std::vector<Settings>& grid)
{
  for (const Settings& s : grid)
    if (std::ranges::none_of(
          trials_, [&](const Trial& t) { return t.settings.label() == s.label(); }))
    {
      Trial trial = trial_of(s);
      if (trial.outcome == Trial::Outcome::waiting && !read_trial(folder_, trial))
        give_up(trial);
      trials_.push_back(std::move(trial));
    }
}

/// The cheapest first.
Sweep::Order Sweep::waiting() const
{
  Order order;
  std::vector<double> seconds(trials_.size());
  for (std::size_t i = 0; i < trials_.size(); ++i)
    if (trials_[i].outcome == Trial::Outcome::waiting)
    {
      seconds[i] = expected(trials_[i]);
      order.push_back(i);
    }
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return seconds[i]; });
  return order;
}

void Sweep::tell_plan() const
{
  double seconds = 0;
  const Order order = waiting();
  for (const std::size_t i : order)
    seconds += expected(trials_[i]);
  int most = 0;
  for (const Trial& t : trials_)
    most = std::max(most, t.settings.triangles);
  tell_(fmt::format("{} runs of up to {} triangles, {} of them to be made: about {} of CPU time, "
                    "{} with {} at a time",
    trials_.size(), most, order.size(), duration_text(seconds), duration_text(seconds / plan_.jobs),
    plan_.jobs));
}

void Sweep::carry_out(const Order& order)
{
  std::list<Running> running;
  for (auto next = order.begin(); next != order.end() || !running.empty();)
  {
    if (interrupted() && next != order.end())
    {
      next = order.end();
      for (const Running& r : running)
        r.child.interrupt();
    }
    collect_ended(running);
    if (next != order.end() && left_out(running, trials_[*next]))
      ++next;
    else if (next != order.end() && has_room(running, trials_[*next]))
      start(running, *next++);
    else
      std::this_thread::sleep_for(look_every);
  }
}

void Sweep::collect_ended(std::list<Running>& running)
{
  for (auto r = running.begin(); r != running.end();)
    if (r->child.running())
    {
      if (!r->stopped && r->child.cpu_seconds() > patience(trials_[r->trial]))
      {
        r->child.interrupt();
        r->stopped = true;
      }
      ++r;
    }
    else
    {
      record(trials_[r->trial], r->child);
      r = running.erase(r);
    }
}

bool Sweep::has_room(const std::list<Running>& running, const Trial& next) const
{
  const auto memory_of = [](const Trial& t) { return cost_of(t.scene, t.triangles()).memory; };
  double memory = memory_of(next);
  for (const Running& r : running)
    memory += memory_of(trials_[r.trial]);
  return running.empty() ||
    (running.size() < static_cast<std::size_t>(plan_.jobs) && memory < memory_);
}

/// Without these there is nothing to compare, whatever the budget.
bool Sweep::is_needed(const Settings& s) const
{
  return s.preset == Scene::Preset::balanced && s.knob.empty() && s.time == time_ &&
    s.triangles <= 2 * least_triangles;
}

/// Where it would overrun the budget.
bool Sweep::left_out(const std::list<Running>& running, Trial& next) const
{
  double seconds = expected(next);
  for (const Running& r : running)
    seconds += expected(trials_[r.trial]);
  for (const Trial& t : trials_)
    seconds += t.cpu_seconds;
  if (seconds <= plan_.budget || is_needed(next.settings))
    return false;
  next.outcome = Trial::Outcome::left_out;
  next.message = fmt::format("would take about {} of CPU time", duration_text(expected(next)));
  tell_(fmt::format("  {} is left out: {}", next.settings.label(), next.message));
  return true;
}

void Sweep::start(std::list<Running>& running, std::size_t trial) const
{
  const Settings& settings = trials_[trial].settings;
  replace_file(folder_.scene_file(settings), write_scene(trials_[trial].scene));
  const std::vector<std::string> arguments{ "run", folder_.scene_file(settings).string(), "-o",
    folder_.run_folder(settings).string(), "--threads",
    std::to_string(threads_a_run(static_cast<int>(plan_.jobs))), "--no-movie", "--no-plots",
    "--quiet", "--overwrite" };
  running.emplace_back(trial, arguments);
}

void Sweep::record(Trial& trial, const ChildRun& child)
{
  if (!read_trial(folder_, trial) && !give_up(trial))
  {
    if (interrupted()) // to be run another time
      return;
    trial.outcome =
      child.code() == exit_code::bad_input ? Trial::Outcome::refused : Trial::Outcome::failed;
    trial.message = child.last_words();
  }
  tell_(fmt::format("  {:<40} {}", trial.settings.label(),
    trial.finished() ? fmt::format("{:6.1f} s, {:.0f} steps", trial.cpu_seconds, trial.steps)
                     : fmt::format("{}: {}", outcome_name(trial.outcome), trial.message)));
}

/// Of a run that was interrupted: whether that was for crawling.
bool Sweep::give_up(Trial& trial) const
{
  if (!(trial.cpu_seconds > patience(trial)))
    return false;
  trial.outcome = Trial::Outcome::failed;
  trial.message =
    fmt::format("given up at t = {:.3g} after {:.0f} steps: it crawls", trial.end, trial.steps);
  return true;
}

double Sweep::patience(const Trial& trial) const
{
  return std::max(least_patience, most_patience * expected(trial));
}

/// By the run that is nearest.
double Sweep::expected_steps(const Trial& trial) const
{
  double steps = unknown_steps, nearest = HUGE_VAL;
  for (const Trial& t : trials_)
  {
    const double apart = distance(t.settings, trial.settings);
    if (t.finished() && apart < nearest)
    {
      nearest = apart;
      steps = t.steps;
    }
  }
  return steps;
}

/// What runs on this basis took, beside what was expected of them.
double Sweep::correction(const Trial& trial) const
{
  double took = 0, model = 0;
  for (const Trial& t : trials_)
    if (t.finished() && t.scene.accuracy.basis == trial.scene.accuracy.basis)
    {
      took += t.cpu_seconds;
      model += expected_seconds(t.scene, t.triangles(), t.steps);
    }
  return took > 0 ? took / model : 1;
}

double Sweep::expected(const Trial& trial) const
{
  return correction(trial) *
    expected_seconds(trial.scene, trial.triangles(), expected_steps(trial));
}

/// What is known of the runs that are there, expected of the others.
double Sweep::total(const std::vector<Settings>& grid) const
{
  double seconds = 0;
  for (const Settings& s : grid)
  {
    const auto there = std::ranges::find_if(
      trials_, [&](const Trial& t) { return t.settings.label() == s.label() && t.steps > 0; });
    const Trial trial = there == trials_.end() ? trial_of(s) : *there;
    if (trial.outcome != Trial::Outcome::refused)
      seconds += trial.steps > 0 ? trial.cpu_seconds : expected(trial);
  }
  return seconds;
}

/// No fewer than tell something.
int Sweep::affordable_triangles() const
{
  int most = 2 * least_triangles;
  for (const int n : triangle_numbers(most_triangles))
    if (n > most && total(settings_grid(n, time_)) <= plan_.budget)
      most = n;
  return most;
}

}
