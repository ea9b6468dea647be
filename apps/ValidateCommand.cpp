// vesicle validate: every published benchmark, computed beside its reference.

#include "apps/Commands.h"
#include "apps/StandardOutput.h"
#include "apps/validate/Cases.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace vesicle
{
namespace
{

struct ValidateOptions
{
  std::vector<std::string> names;
  bool full = false;
  bool list = false;
  std::string json;
  std::string plots;
};

int list_cases(const std::vector<validation::Case>& cases)
{
  for (const validation::Case& item : cases)
  {
    print("{:<28} {} {}\n", item.name, item.set == validation::Case::Set::full ? "full" : "    ",
      item.about);
  }
  return exit_code::done;
}

int validate(const ValidateOptions& options)
{
  const auto cases = validation::chosen_cases(options.names, options.full || options.list);
  if (options.list)
  {
    return list_cases(cases);
  }
  validation::Report::Options where;
  where.full = options.full;
  if (!options.json.empty())
  {
    where.json = options.json;
  }
  if (!options.plots.empty())
  {
    where.plots = options.plots;
  }
  validation::Report report(where);
  for (const validation::Case& item : cases)
  {
    validation::run_case(item, report);
  }
  report.print_total();
  return report.failures() > 0 ? exit_code::check_failed : exit_code::done;
}

}

void add_validate_command(CLI::App& app, Action& action)
{
  auto options = std::make_shared<ValidateOptions>();
  auto* command = app.add_subcommand(
    "validate", "Published and exact results, computed by this build beside their references");
  command->add_option(
    "names", options->names, "Cases or families of them (default: all of the set)");
  command->add_flag("--full", options->full,
    "The full set, at the paper's 1,280 triangles (default: a fast set, mostly at 320)");
  command->add_flag("--list", options->list, "List the cases, run none");
  command->add_option("--json", options->json, "File to write the rows to");
  command->add_option("--plots", options->plots, "Folder to draw charts and pictures into");
  command->footer("Example: vesicle validate fig4 fig5 --plots plots --json rows.json\n"
                  "Exit code 1 when a row failed.");
  command->callback([options, &action] { action = [options] { return validate(*options); }; });
}

}
