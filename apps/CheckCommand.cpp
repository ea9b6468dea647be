// vesicle check: what a scene is understood as, and what a run of it would take.

#include "apps/Commands.h"
#include "apps/JsonText.h"
#include "apps/RunFolder.h"
#include "apps/SceneCheck.h"
#include "apps/StandardOutput.h"

#include "solver/scene/SceneFile.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <memory>

namespace vesicle
{
namespace
{

struct CheckOptions
{
  std::string scene;
  std::string folder;
  std::vector<std::string> overrides;
  bool json = false;
};

int check(const CheckOptions& options)
{
  const Scene scene = read_scene(options.scene, options.overrides);
  const SceneCheck found = check_scene(scene, run_folder_of(scene, options.folder));
  if (options.json)
  {
    auto all = to_json(found);
    all["settings"] = write_scene(scene);
    print("{}\n", json_text(all, 2));
    return exit_code::done;
  }
  print("{}\n{}", annotated_scene(options.scene, options.overrides), to_text(found));
  return exit_code::done;
}

}

void add_check_command(CLI::App& app, Action& action)
{
  auto options = std::make_shared<CheckOptions>();
  auto* command = app.add_subcommand("check",
    "What a scene is understood as: all settings, dimensionless numbers, mesh, cost and warnings");
  command->add_option("scene", options->scene, "Scene (TOML)")->required();
  command->add_option("-o,--output", options->folder,
    "Folder that the run would write to; ./<scene name> if left out");
  command
    ->add_option(
      "--set", options->overrides, "table.key=value instead of the scene's, once a setting")
    ->allow_extra_args(false);
  command->add_flag("--json", options->json, "Print JSON");
  command->footer("Example: vesicle check pear.toml --set vesicle.triangles=5120");
  command->callback([options, &action] { action = [options] { return check(*options); }; });
}

}
