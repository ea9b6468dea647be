#pragma once
// The subcommands of `vesicle`. Each adds itself to the command line and says what to do when it is
// chosen.

#include <CLI/App.hpp>

#include <functional>

namespace vesicle
{

/// What every command ends with.
namespace exit_code
{
inline constexpr int done = 0;
inline constexpr int check_failed = 1; ///< a row of `validate`
inline constexpr int bad_input = 2;    ///< usage, scene or mesh
inline constexpr int numerical = 3;    ///< the simulation could not go on
inline constexpr int io = 4;           ///< a file could not be read or written while working
inline constexpr int interrupted = 130;
}

/// Does the command's work and returns its exit code; throws the errors of solver/Errors.h.
using Action = std::function<int()>;

/// Each sets `action` when the user chooses it.
void add_new_command(CLI::App& app, Action& action);
void add_check_command(CLI::App& app, Action& action);
void add_run_command(CLI::App& app, Action& action);
void add_sweep_command(CLI::App& app, Action& action);
void add_shape_command(CLI::App& app, Action& action);
void add_fill_command(CLI::App& app, Action& action);
void add_equilibrium_command(CLI::App& app, Action& action);
void add_curvature_command(CLI::App& app, Action& action);
void add_repair_command(CLI::App& app, Action& action);
void add_info_command(CLI::App& app, Action& action);
void add_compare_command(CLI::App& app, Action& action);
void add_convert_command(CLI::App& app, Action& action);
void add_render_command(CLI::App& app, Action& action);
void add_validate_command(CLI::App& app, Action& action);
void add_tradeoff_command(CLI::App& app, Action& action);

}
