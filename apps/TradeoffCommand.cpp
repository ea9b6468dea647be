// vesicle tradeoff: what accuracy costs in a scene.

#include "apps/Attempts.h"
#include "apps/Commands.h"
#include "apps/Interrupt.h"
#include "apps/StandardOutput.h"
#include "apps/Warning.h"
#include "apps/tradeoff/Observables.h"
#include "apps/tradeoff/Report.h"
#include "apps/tradeoff/Sweep.h"

#include "render/RenderBackend.h"
#include "solver/Errors.h"
#include "solver/files/FileBytes.h"
#include "solver/files/FileLock.h"
#include "solver/scene/TomlText.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <memory>
#include <thread>

namespace vesicle
{
namespace
{

struct TradeoffOptions
{
  std::string scene;
  std::string folder;
  std::vector<std::string> overrides;
  std::vector<std::string> observables;
  std::vector<std::string> exact;
  double tolerance = 1e-3;
  double budget = 300;
  std::optional<double> end;
  unsigned jobs = std::min(2U, std::max(1U, std::thread::hardware_concurrency()));
};

tradeoff::SweepPlan plan_of(const TradeoffOptions& options)
{
  std::vector<std::string> overrides = options.overrides;
  if (options.end)
    overrides.push_back("time.end=" + to_toml(*options.end));
  const std::string name = std::filesystem::path(options.scene).stem().string();
  return { options.scene, overrides, options.folder.empty() ? name + "-tradeoff" : options.folder,
    options.budget, static_cast<int>(options.jobs) };
}

/// A picture that can't be drawn doesn't lose the rest.
void write_report(const tradeoff::Report& report, const std::filesystem::path& folder)
{
  const auto write = [&](const char* name, auto&& writer)
  {
    writer(report, folder / name);
    print("{}\n", (folder / name).string());
  };
  write("tradeoff.csv", tradeoff::write_table);
  write("tradeoff.json", tradeoff::write_json);
  write("recommended.toml", tradeoff::write_recommended);
  try
  {
    render_backend();
  }
  catch (const NothingToDrawWith& error)
  {
    warn(fmt::format("no charts: {}", error.what()));
    return;
  }
  write("tradeoff.png", tradeoff::draw);
  write("tradeoff.svg", tradeoff::draw);
}

int find_tradeoff(const TradeoffOptions& options)
{
  spdlog::set_level(spdlog::level::warn);
  watch_for_interrupts();
  const tradeoff::SweepPlan plan = plan_of(options);
  const auto tell = [](const std::string& line)
  {
    print("{}\n", line);
    flush_standard_output();
  };
  tradeoff::Sweep sweep(plan, tell);
  tradeoff::Report report;
  report.scene = options.scene;
  report.observables = tradeoff::chosen_observables(options.observables, sweep.scene());
  report.tolerance = options.tolerance;
  report.known = tradeoff::known_values(sweep.scene());
  for (const auto& [name, value] : tradeoff::exact_values(options.exact, sweep.scene()))
    report.known[name] = value;
  make_folder(plan.folder);
  const FileLock lock(plan.folder / "vesicle.lock");
  sweep.run();
  report.trials = sweep.trials();
  try
  {
    tradeoff::conclude(report);
  }
  catch (const NumericalError&)
  {
    if (interrupted()) // too few runs to say anything, yet
      return exit_code::interrupted;
    throw;
  }
  write_report(report, plan.folder);
  print("\n{}", tradeoff::to_text(report));
  return interrupted() ? exit_code::interrupted : exit_code::done;
}

}

void add_tradeoff_command(CLI::App& app, Action& action)
{
  auto options = std::make_shared<TradeoffOptions>();
  auto* command = app.add_subcommand(
    "tradeoff", "What accuracy costs in a scene, and the cheapest settings that keep a tolerance");
  command->add_option("scene", options->scene, "Scene (TOML)")->required();
  command
    ->add_option("--tolerance", options->tolerance,
      "Error that each observable may have, relative to its magnitude (angles: to a radian)")
    ->check(CLI::Range(1e-12, 1.))
    ->capture_default_str();
  command->add_option("--budget", options->budget, "Seconds of CPU time for all runs together")
    ->check(CLI::PositiveNumber)
    ->capture_default_str();
  command
    ->add_option("--observables", options->observables,
      "Columns of a run's table, at its end; of several vesicles the mean or, as velocity_z[1], "
      "one's; by the scene's physics if left out")
    ->delimiter(',')
    ->allow_extra_args(false);
  command
    ->add_option("--exact", options->exact,
      "OBSERVABLE=VALUE where it is known, to be told beside; once an observable")
    ->allow_extra_args(false);
  command->add_option("--end", options->end, "A shorter piece: time.end of the runs")
    ->check(CLI::PositiveNumber);
  command
    ->add_option(
      "--set", options->overrides, "table.key=value instead of the scene's, once a setting")
    ->allow_extra_args(false);
  command->add_option("-o,--output", options->folder,
    "Folder to write to; ./<scene>-tradeoff if left out. Runs that are there aren't repeated");
  command->add_option("-j,--jobs", options->jobs, "Runs at a time")
    ->check(CLI::Range(1U, 1024U))
    ->capture_default_str();
  command->footer("Example: vesicle tradeoff pear.toml --tolerance 1e-3 -o trade");
  command->callback([options, &action] { action = [options] { return find_tradeoff(*options); }; });
}

}
