// vesicle run: a scene, from start to end.

#include "apps/Commands.h"
#include "apps/Run.h"
#include "apps/SceneEquilibriumFile.h"

#include "solver/scene/SceneFile.h"

#include <CLI/CLI.hpp>
#include <oneapi/tbb/global_control.h>
#include <spdlog/spdlog.h>

#include <memory>

namespace vesicle
{
namespace
{

struct RunCommandOptions
{
  std::string scene;
  std::string folder;
  std::vector<std::string> overrides;
  std::string merge;
  std::size_t threads = 0;
  bool no_movie = false;
  bool no_plots = false;
  RunOptions run;
};

int run_scene(const RunCommandOptions& options)
{
  using oneapi::tbb::global_control;
  std::optional<global_control> threads; // VTK's own loops share it
  if (options.threads > 0)
  {
    threads.emplace(global_control::max_allowed_parallelism, options.threads);
  }
  spdlog::set_level(spdlog::level::warn);
  std::vector<std::string> overrides = options.overrides;
  if (!options.merge.empty())
  {
    overrides.push_back("vesicle.merge=" + options.merge);
  }
  const Scene scene = read_scene(options.scene, overrides);
  const auto folder = run_folder_of(scene, options.folder);
  if (scene.time.equilibrium)
  {
    return run_to_equilibrium(scene, folder, options.run.overwrite, options.run.quiet);
  }
  RunOptions run = options.run;
  run.movie = !options.no_movie;
  run.plots = !options.no_plots;
  return Run(scene, folder, run).carry_out();
}

}

void add_run_command(CLI::App& app, Action& action)
{
  auto options = std::make_shared<RunCommandOptions>();
  auto* command = app.add_subcommand("run", "Simulate a scene");
  command->add_option("scene", options->scene, "Scene (TOML)")->required();
  command->add_option(
    "-o,--output", options->folder, "Folder to write to; ./<scene name> if left out");
  command
    ->add_option(
      "--set", options->overrides, "table.key=value instead of the scene's, once a setting")
    ->allow_extra_args(false);
  command->add_option("--merge", options->merge,
    "Points of the scene's start mesh nearer than this distance become one: vesicle.merge");
  auto* resume = command->add_flag("--resume", options->run.resume,
    "Go on from the checkpoint in the folder (start where there is no run yet)");
  command->add_flag("--overwrite", options->run.overwrite, "Replace the run in the folder")
    ->excludes(resume);
  command->add_option("--threads", options->threads, "Threads to use; all processors if left out")
    ->check(CLI::PositiveNumber);
  command->add_flag("--no-movie", options->no_movie, "No pictures and no film at the end");
  command->add_flag("--no-plots", options->no_plots, "No charts of the diagnostics at the end");
  command->add_flag("--quiet", options->run.quiet, "Print nothing but errors");
  command->footer("Example: vesicle run pear.toml -o pear --set time.end=5");
  command->callback([options, &action] { action = [options] { return run_scene(*options); }; });
}

}
