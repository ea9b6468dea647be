// vesicle sweep: a scene with many settings.

#include "apps/Commands.h"
#include "apps/ParameterSweep.h"
#include "apps/StandardOutput.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace vesicle
{
namespace
{

struct SweepOptions
{
  SweepSettings settings;
  std::string scene, folder, slurm;
  std::vector<std::string> over;
  bool table = false;
};

int sweep(SweepOptions options)
{
  options.settings.scene = options.scene;
  options.settings.folder = options.folder;
  for (const std::string& range : options.over)
  {
    options.settings.ranges.push_back(parse_range(range));
  }
  ParameterSweep sweep(options.settings);
  if (!options.slurm.empty())
  {
    sweep.write_slurm(options.slurm);
    print("sbatch {}\n", options.slurm);
    return exit_code::done;
  }
  if (options.table)
  {
    sweep.write_table();
    print("{}\n", sweep.table().string());
    return exit_code::done;
  }
  return sweep.run();
}

}

void add_sweep_command(CLI::App& app, Action& action)
{
  auto options = std::make_shared<SweepOptions>();
  SweepSettings& settings = options->settings;
  auto* command = app.add_subcommand(
    "sweep", "Run a scene with many settings, a folder each and one table; again: goes on");
  command->add_option("scene", options->scene, "Scene (TOML)")->required();
  command
    ->add_option("--over", options->over,
      "table.key=0.5,1,2 or table.key=from:to:step; several: each with each")
    ->allow_extra_args(false)
    ->required();
  command->add_option("--set", settings.overrides, "table.key=value of all runs, once a setting")
    ->allow_extra_args(false);
  command->add_option(
    "-o,--output", options->folder, "Folder for all; ./<scene name>-sweep if left out");
  command->add_option("-j,--jobs", settings.jobs, "Runs at a time")
    ->check(CLI::PositiveNumber)
    ->capture_default_str();
  command
    ->add_option(
      "--threads", settings.threads, "Of each run; the processors shared out if left out")
    ->check(CLI::PositiveNumber);
  command->add_flag("--movies", settings.movies, "Pictures and charts of each run");
  auto* slurm = command->add_option("--slurm", options->slurm,
    "Run nothing: write a job array for Slurm that does, a run a job, to this file");
  command
    ->add_flag("--table", options->table, "Run nothing: write the table of what is there so far")
    ->excludes(slurm);
  command->add_flag("--quiet", settings.quiet, "Print nothing but errors");
  command->footer("Example: vesicle sweep pear.toml --over membrane.bending_rigidity=0.5,1,2 "
                  "--over vesicle.reduced_volume=0.9:0.6:0.1 -j 2");
  command->callback([options, &action] { action = [options] { return sweep(*options); }; });
}

}
