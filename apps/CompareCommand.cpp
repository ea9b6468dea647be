// vesicle compare: two runs, or two meshes.

#include "apps/Commands.h"
#include "apps/Comparison.h"
#include "apps/JsonText.h"
#include "apps/StandardOutput.h"

#include "solver/Errors.h"
#include "solver/files/FileBytes.h"
#include "vtkfilters/Filters/SeriesFile.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace vesicle
{
namespace
{

struct CompareOptions
{
  std::string a, b;
  CompareSettings settings;
  bool json = false;
};

bool is_run(const std::string& input)
{
  return is_folder(input) || is_series(input);
}

template<class Comparison>
void print_comparison(const Comparison& comparison, bool json)
{
  json ? print("{}\n", json_text(to_json(comparison), 2)) : print("{}", to_text(comparison));
}

int compare(const CompareOptions& options)
{
  const bool runs = is_run(options.a);
  if (runs != is_run(options.b))
  {
    throw InputError(fmt::format("{} is a run and {} a mesh: give two runs or two meshes",
      runs ? options.a : options.b, runs ? options.b : options.a));
  }
  if (runs)
  {
    print_comparison(compare_runs(options.a, options.b, options.settings), options.json);
  }
  else
  {
    print_comparison(compare_meshes(options.a, options.b, options.settings.centred), options.json);
  }
  return exit_code::done;
}

}

void add_compare_command(CLI::App& app, Action& action)
{
  auto options = std::make_shared<CompareOptions>();
  auto* command = app.add_subcommand("compare",
    "Two runs at the times that both have, or two meshes: how far the "
    "surfaces are apart, and how the observables differ");
  command->add_option("a", options->a, "Folder of a run, series (.pvd .vtu.series), or mesh")
    ->required();
  command->add_option("b", options->b, "The other one")->required();
  command
    ->add_option("--columns", options->settings.columns,
      "Of the tables of diagnostics; if left out the usual ones")
    ->delimiter(',');
  command->add_flag("--centred", options->settings.centred,
    "Compare shapes about the centroids of their volumes, wherever they are");
  command->add_flag("--json", options->json, "Print JSON, with all values at all times");
  command->footer("Example: vesicle compare coarse fine --columns energy_over_8pi,velocity_z");
  command->callback([options, &action] { action = [options] { return compare(*options); }; });
}

}
