// The command `vesicle`.

#include "apps/BuildFacts.h"
#include "apps/Commands.h"
#include "apps/HelpPages.h"
#include "apps/StandardOutput.h"

#include "solver/Doing.h"
#include "solver/Errors.h"
#include "solver/KeptMemory.h"
#include "solver/linear/Blas.h"
#include "solver/scene/NearestName.h"

#include "vtkLogger.h"
#include "vtkOutputWindow.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <iostream>
#include <string>
#include <system_error>
#include <vector>

namespace vesicle
{
namespace
{

int fail(const std::exception& error, int code)
{
  std::cerr << "vesicle: " << error.what() << '\n';
  return code;
}

/// As the user typed it.
std::string command_line(int argc, char** argv)
{
  std::string line = "vesicle";
  for (int i = 1; i < argc; ++i)
  {
    line += std::string(" ") + argv[i];
  }
  return line;
}

/// The one place where errors become exit codes. An error that doesn't say what was being done is
/// told with the command.
int carry_out(const Action& action, const std::string& command)
{
  try
  {
    return doing(command, action);
  }
  catch (const InputError& error)
  {
    return fail(error, exit_code::bad_input);
  }
  catch (const NumericalError& error)
  {
    return fail(error, exit_code::numerical);
  }
  catch (const std::exception& error) // IoError, UnforeseenError
  {
    return fail(error, exit_code::io);
  }
}

/// What a command ends with that did its work, if its words got out. A reader who left needs none.
int checked_output(int code)
{
  const int reason = standard_output_error();
  if (reason != 0 && reason != EPIPE)
  {
    std::cerr << "vesicle: standard output: can't be written: "
              << std::generic_category().message(reason) << '\n';
  }
  return reason != 0 && code == exit_code::done ? exit_code::io : code;
}

/// A first word that is no command is told with the command that was probably meant.
void require_command(const CLI::App& app, int argc, char** argv)
{
  if (argc < 2 || argv[1][0] == '-')
    return;
  std::vector<std::string> known;
  for (const CLI::App* command : app.get_subcommands({}))
    known.push_back(command->get_name());
  const std::string name = argv[1];
  if (std::find(known.begin(), known.end(), name) != known.end())
    return;
  const std::string nearest = nearest_name(name, known);
  std::string commands;
  for (const std::string& command : known)
    commands += " " + command;
  throw InputError(fmt::format("there is no command '{}'{}; commands:{}", name,
    nearest.empty() ? "" : fmt::format(", did you mean '{}'?", nearest), commands));
}

/// VTK would log every message, also those that are caught and told in our own words.
void use_output_window_only()
{
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkOutputWindow::GetInstance()->SetDisplayMode(vtkOutputWindow::ALWAYS_STDERR);
}

int run_command_line(int argc, char** argv)
{
  CLI::App app{ "Lipid vesicles in viscous flow by the boundary element method." };
  app.name("vesicle");
  app.footer("Example: vesicle run pear.toml -o pear");
  app.set_version_flag("--version", version_text, "Print the version and what it was built with");
  app.require_subcommand(1);
  Action action;
  add_new_command(app, action);
  add_check_command(app, action);
  add_run_command(app, action);
  add_sweep_command(app, action);
  add_shape_command(app, action);
  add_fill_command(app, action);
  add_equilibrium_command(app, action);
  add_curvature_command(app, action);
  add_repair_command(app, action);
  add_info_command(app, action);
  add_compare_command(app, action);
  add_convert_command(app, action);
  add_render_command(app, action);
  add_validate_command(app, action);
  add_tradeoff_command(app, action);
  if (argc == 3 && argv[1] == std::string("--help-pages")) // for the build
  {
    return carry_out(
      [&]
      {
        write_help_pages(app, argv[2]);
        return exit_code::done;
      },
      command_line(argc, argv));
  }
  try
  {
    require_command(app, argc, argv);
    app.parse(argc, argv);
  }
  catch (const InputError& error)
  {
    return fail(error, exit_code::bad_input);
  }
  catch (const CLI::ParseError& outcome)
  {
    return app.exit(outcome) == 0 ? exit_code::done : exit_code::bad_input;
  }
  return carry_out(action, command_line(argc, argv));
}

}
}

int main(int argc, char** argv)
{
  vesicle::prepare_standard_streams();
  vesicle::restart_with_blas_kernel(argv);
  vesicle::keep_freed_memory();
  vesicle::use_output_window_only();
  return vesicle::checked_output(vesicle::run_command_line(argc, argv));
}
