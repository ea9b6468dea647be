// vesicle equilibrium: shapes at rest, without a fluid.

#include "apps/Commands.h"
#include "apps/EquilibriumSweep.h"
#include "apps/EquilibriumText.h"
#include "apps/SceneEquilibriumFile.h"
#include "apps/StandardOutput.h"

#include "solver/Errors.h"
#include "solver/equilibrium/BranchEquilibrium.h"
#include "solver/scene/SceneFile.h"
#include "solver/simulation/EquilibriumOfScene.h"
#include "vtkfilters/Filters/MeshFiles.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>

#include <memory>

namespace vesicle
{
namespace
{

struct EquilibriumOptions
{
  std::string scene;
  std::vector<std::string> overrides;
  std::string branch;
  BranchRequest request;
  std::string output;
  std::string sweep;
  double step = 0.05;
  std::size_t threads = 0;
  bool json = false;
  bool with_reduced_volume = false;
};

/// "A:B" with A < B, both above 0, B at most 1.
std::array<double, 2> range_of(const std::string& text)
{
  double from = 0, to = 0;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%lf:%lf%c", &from, &to, &rest) != 2 ||
    !(from > 0 && from < to && to <= 1))
  {
    throw InputError(
      fmt::format("--sweep {}: wants two reduced volumes A:B with 0 < A < B <= 1, as .3:1", text));
  }
  return { from, to };
}

int tell(
  const EquilibriumReport& report, const TriangleMesh& mesh, const std::string& file, bool json)
{
  write_equilibrium(report, mesh, file);
  print("{}", json ? to_json_text(report) : file + "\n" + to_text(report));
  return exit_code::done;
}

int of_branch(const EquilibriumOptions& options)
{
  const std::string file = options.output.empty() ? options.branch + ".vtu" : options.output;
  require_mesh_ending(file);
  const BranchEquilibrium found = branch_equilibrium(options.request);
  EquilibriumReport report = report_of(found.equilibrium, found.mesh);
  report.branch = options.branch;
  if (!options.request.follow)
  {
    report.energy_error = found.equilibrium.energy / found.axisymmetric_energy - 1;
  }
  return tell(report, found.mesh, file, options.json);
}

int of_scene(const EquilibriumOptions& options)
{
  const Scene scene = read_scene(options.scene, options.overrides);
  require_equilibrium(scene);
  const std::string file = options.output.empty() ? scene.name + ".vtu" : options.output;
  require_mesh_ending(file);
  TriangleMesh mesh;
  const EquilibriumReport report = equilibrium_of_scene(scene, options.request.follow, mesh);
  return tell(report, mesh, file, options.json);
}

int find_equilibrium(EquilibriumOptions options)
{
  std::optional<oneapi::tbb::global_control> threads;
  if (options.threads > 0)
  {
    threads.emplace(oneapi::tbb::global_control::max_allowed_parallelism, options.threads);
  }
  if (!options.sweep.empty())
  {
    const auto [from, to] = range_of(options.sweep);
    return sweep_equilibria({ from, to, options.step, options.request.triangles },
      options.output.empty() ? "equilibria" : options.output);
  }
  if (!options.scene.empty())
  {
    return of_scene(options);
  }
  if (options.branch.empty() || !options.with_reduced_volume)
  {
    throw InputError("equilibrium wants a scene, or --branch and --reduced-volume, or --sweep");
  }
  options.request.branch = equilibrium_branch(options.branch);
  return of_branch(options);
}

}

void add_equilibrium_command(CLI::App& app, Action& action)
{
  auto options = std::make_shared<EquilibriumOptions>();
  auto* command = app.add_subcommand(
    "equilibrium", "The shape of least energy at given area and volume, without a fluid");
  auto* scene = command->add_option("scene", options->scene,
    "Scene (TOML) without flow and gravity: downhill from its start shape");
  command
    ->add_option(
      "--set", options->overrides, "table.key=value instead of the scene's, once a setting")
    ->allow_extra_args(false)
    ->needs(scene);
  auto* branch =
    command->add_option("--branch", options->branch, "prolate oblate stomatocyte")->excludes(scene);
  auto* reduced = command
                    ->add_option("--reduced-volume", options->request.reduced_volume,
                      "6 sqrt(pi) V / A^(3/2), 1 for a sphere")
                    ->excludes(scene);
  command
    ->add_option(
      "--triangles", options->request.triangles, "The nearest multiple of 10 or 12; of a branch")
    ->capture_default_str()
    ->excludes(scene);
  auto* sweep = command
                  ->add_option("--sweep", options->sweep,
                    "A:B, from one reduced volume to another: table and diagram of all branches")
                  ->excludes(scene)
                  ->excludes(branch)
                  ->excludes(reduced);
  command->add_option("--step", options->step, "Of the sweep's reduced volume")
    ->check(CLI::Range(1e-3, 1.))
    ->capture_default_str()
    ->needs(sweep);
  command
    ->add_flag("--follow", options->request.follow,
      "From an unstable shape on downhill, along its most unstable deformation")
    ->excludes(sweep);
  command->add_option("-o,--output", options->output,
    "Mesh to write (BRANCH.vtu or the scene's name); with --sweep a folder (equilibria)");
  command->add_option("--threads", options->threads, "Threads to use; all processors if left out")
    ->check(CLI::PositiveNumber);
  command->add_flag("--json", options->json, "Print JSON")->excludes(sweep);
  command->footer("Example: vesicle equilibrium --reduced-volume 0.6 --branch oblate -o disc.vtu");
  command->callback(
    [options, reduced, &action]
    {
      options->with_reduced_volume = reduced->count() > 0;
      action = [options] { return find_equilibrium(*options); };
    });
}

}
