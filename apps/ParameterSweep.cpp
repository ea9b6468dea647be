#include "apps/ParameterSweep.h"

#include "apps/ChildRun.h"
#include "apps/Commands.h"
#include "apps/Interrupt.h"
#include "apps/RunReport.h"
#include "apps/RunTable.h"
#include "apps/StandardOutput.h"
#include "apps/Warning.h"

#include "solver/Errors.h"
#include "solver/Joined.h"
#include "solver/files/FileBytes.h"
#include "solver/scene/SceneFile.h"
#include "solver/state/RunRows.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <list>
#include <thread>

namespace vesicle
{
namespace
{

constexpr std::chrono::milliseconds patience{ 50 }; // between looks at the runs

/// As a field of a table.
std::string field(const std::string& text)
{
  if (text.find_first_of(",\"\n") == std::string::npos)
  {
    return text;
  }
  std::string quoted = "\"";
  for (const char c : text)
  {
    quoted += c == '"' ? "\"\"" : std::string(1, c);
  }
  return quoted + '"';
}

/// In single quotes of a shell.
std::string shell(const std::string& text)
{
  std::string quoted = "'";
  for (const char c : text)
  {
    quoted += c == '\'' ? "'\\''" : std::string(1, c);
  }
  return quoted + "'";
}

struct Running
{
  Running(const GridPoint& of, const std::vector<std::string>& arguments)
    : point(&of), child(arguments)
  {
  }

  const GridPoint* point;
  ChildRun child;
};

bool is_done(const std::string& state)
{
  return state == "finished" || state == "steady";
}

}

ParameterSweep::ParameterSweep(SweepSettings settings)
  : settings_(std::move(settings)), grid_(parameter_grid(settings_.ranges))
{
  if (settings_.threads == 0)
  {
    settings_.threads = threads_a_run(settings_.jobs);
  }
  for (const GridPoint& point : grid_)
  {
    std::vector<std::string> overrides = settings_.overrides;
    overrides.insert(overrides.end(), point.overrides.begin(), point.overrides.end());
    const Scene scene = read_scene(settings_.scene, overrides);
    if (scene.time.equilibrium)
    {
      throw InputError(settings_.scene.string() +
        ": a sweep is of runs in time; of equilibria `vesicle equilibrium --sweep` makes one");
    }
    if (settings_.folder.empty())
    {
      settings_.folder = scene.name + "-sweep";
    }
  }
}

std::filesystem::path ParameterSweep::folder_of(const GridPoint& point) const
{
  return settings_.folder / point.name;
}

std::filesystem::path ParameterSweep::table() const
{
  return settings_.folder / "sweep.csv";
}

std::vector<std::string> ParameterSweep::arguments_of(const GridPoint& point) const
{
  std::vector<std::string> arguments{ "run", settings_.scene.string(), "-o",
    folder_of(point).string(), "--resume", "--quiet", "--threads",
    std::to_string(settings_.threads) };
  for (const auto* overrides : { &settings_.overrides, &point.overrides })
  {
    for (const std::string& override : *overrides)
    {
      arguments.insert(arguments.end(), { "--set", override });
    }
  }
  if (!settings_.movies)
  {
    arguments.insert(arguments.end(), { "--no-movie", "--no-plots" });
  }
  return arguments;
}

/// "missing" where no run was begun.
std::string ParameterSweep::state_of(const GridPoint& point) const
{
  try
  {
    return report_of_run(folder_of(point)).state;
  }
  catch (const InputError&)
  {
    return "missing";
  }
}

int ParameterSweep::record(const GridPoint& point, const ChildRun& child) const
{
  const int code = child.code();
  write_table();
  if (code == exit_code::interrupted)
  {
    return code;
  }
  if (code != exit_code::done)
  {
    warn(fmt::format("{}: {}", folder_of(point).string(), child.last_words()));
  }
  else if (!settings_.quiet)
  {
    print("{}: {}\n", folder_of(point).string(), state_of(point));
    flush_standard_output();
  }
  return code;
}

int ParameterSweep::run()
{
  watch_for_interrupts();
  make_folder(settings_.folder);
  std::list<const GridPoint*> waiting;
  for (const GridPoint& point : grid_)
  {
    if (!is_done(state_of(point)))
    {
      waiting.push_back(&point);
    }
  }
  write_table();
  if (!settings_.quiet)
  {
    print("{} runs, {} of them done; table: {}\n", grid_.size(), grid_.size() - waiting.size(),
      table().string());
    flush_standard_output();
  }
  int worst = exit_code::done;
  std::list<Running> running;
  while (!interrupted() && (!waiting.empty() || !running.empty()))
  {
    while (!waiting.empty() && static_cast<int>(running.size()) < settings_.jobs)
    {
      running.emplace_back(*waiting.front(), arguments_of(*waiting.front()));
      waiting.pop_front();
    }
    std::this_thread::sleep_for(patience);
    for (auto run = running.begin(); run != running.end();)
    {
      if (run->child.running())
      {
        ++run;
        continue;
      }
      worst = std::max(worst, record(*run->point, run->child));
      run = running.erase(run);
    }
  }
  running.clear(); // each is asked to end, and saves
  write_table();
  return interrupted() ? exit_code::interrupted : worst;
}

void ParameterSweep::write_table() const
{
  std::vector<std::string> names{ "folder" };
  for (const ParameterRange& range : settings_.ranges)
  {
    names.push_back(range.key);
  }
  names.push_back("state");
  const Scene scene = read_scene(settings_.scene, settings_.overrides);
  const auto columns = run_columns(rows_of(scene));
  names.insert(names.end(), columns.begin(), columns.end());
  std::string text = joined(names, ",") + "\n";
  const auto add_row = [&](const GridPoint& point, const RunReport& report, const auto& last)
  {
    std::vector<std::string> row{ point.name };
    for (const std::string& value : point.values)
    {
      row.push_back(field(value));
    }
    row.push_back(report.state);
    for (const auto& column : columns)
    {
      const auto found = last.find(column);
      row.push_back(
        found != last.end() && found->second ? fmt::format("{}", *found->second) : std::string());
    }
    text += joined(row, ",") + "\n";
  };
  for (const GridPoint& point : grid_)
  {
    RunReport report;
    report.state = "missing";
    try
    {
      report = report_of_run(folder_of(point));
    }
    catch (const InputError&) // nothing was begun there
    {
    }
    add_row(point, report, report.last);
    for (const auto& last : report.others)
    {
      add_row(point, report, last);
    }
  }
  make_folder(settings_.folder);
  replace_file(table(), text);
}

void ParameterSweep::write_slurm(const std::filesystem::path& file) const
{
  std::string text =
    fmt::format("#!/bin/bash\n"
                "# {} runs of {}. The table of them, once they are done:\n"
                "# the same vesicle sweep command with --table in place of --slurm\n"
                "#SBATCH --job-name=vesicle-sweep\n"
                "#SBATCH --array=0-{}%{}\n"
                "#SBATCH --cpus-per-task={}\n"
                "cd {} || exit 4\n"
                "case $SLURM_ARRAY_TASK_ID in\n",
      grid_.size(), settings_.scene.string(), grid_.size() - 1, settings_.jobs, settings_.threads,
      shell(std::filesystem::current_path().string()));
  for (std::size_t i = 0; i < grid_.size(); ++i)
  {
    text += fmt::format("  {}) arguments=(", i);
    for (const std::string& argument : arguments_of(grid_[i]))
    {
      text += shell(argument) + " ";
    }
    text.back() = ')';
    text += " ;;\n";
  }
  text += "esac\nexec " + shell(std::filesystem::canonical("/proc/self/exe").string()) +
    " \"${arguments[@]}\"\n";
  replace_file(file, text);
}

}
