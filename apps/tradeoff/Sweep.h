#pragma once
// The runs of a trade-off, each a process of its own, a few at a time.

#include "apps/ChildRun.h"
#include "apps/tradeoff/Trial.h"

#include <filesystem>
#include <functional>
#include <list>
#include <string>
#include <vector>

namespace vesicle::tradeoff
{

struct SweepPlan
{
  std::filesystem::path scene; ///< file
  std::vector<std::string> overrides;
  std::filesystem::path folder; ///< runs go to folder/runs
  double budget;                ///< seconds of CPU, for all runs
  int jobs;                     ///< runs at a time, each on an equal share of the processors
};

class Sweep
{
public:
  /// `tell` is given a line to show now and then. Throws InputError for a scene that can't be read, or
  /// whose runs don't end at a given time.
  Sweep(SweepPlan plan, std::function<void(const std::string&)> tell);

  /// Runs what is missing, or until Ctrl-C. First the coarsest meshes, which tell how many steps there
  /// are; then the grid of the most triangles that the budget allows, the cheapest first. Throws IoError.
  void run();
  /// In the order of the grid.
  const std::vector<Trial>& trials() const { return trials_; }
  /// With the default preset.
  const Scene& scene() const { return scene_; }

private:
  using Order = std::vector<std::size_t>; ///< of trials
  struct Running
  {
    Running(std::size_t t, const std::vector<std::string>& arguments) : trial(t), child(arguments)
    {
    }

    std::size_t trial;
    ChildRun child;
    bool stopped = false; ///< was asked to end
  };

  Trial trial_of(const Settings& settings) const;
  void add(const std::vector<Settings>& grid);
  Order waiting() const;
  void tell_plan() const;

  void carry_out(const Order& order);
  void collect_ended(std::list<Running>& running);
  bool has_room(const std::list<Running>& running, const Trial& next) const;
  bool is_needed(const Settings& settings) const;
  bool left_out(const std::list<Running>& running, Trial& next) const;
  void start(std::list<Running>& running, std::size_t trial) const;
  void record(Trial& trial, const ChildRun& child);
  bool give_up(Trial& trial) const;
  double patience(const Trial& trial) const;

  double expected_steps(const Trial& trial) const;
  double correction(const Trial& trial) const;
  double expected(const Trial& trial) const;
  double total(const std::vector<Settings>& grid) const;
  int affordable_triangles() const;

  SweepPlan plan_;
  std::function<void(const std::string&)> tell_;
  TrialFolder folder_;
  Scene scene_;
  TimeSetting time_;
  std::vector<Trial> trials_;
  double memory_; ///< bytes that there are
};

}
