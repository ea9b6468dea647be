// vesicle new: a shipped scene to start one's own from.

#include "apps/Commands.h"
#include "apps/DataFiles.h"
#include "apps/StandardOutput.h"
#include "apps/Warning.h"

#include "solver/Errors.h"
#include "solver/Joined.h"
#include "solver/files/FileBytes.h"
#include "solver/flow/FlowKind.h"
#include "solver/scene/NearestName.h"
#include "solver/scene/SceneFile.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <sstream>

namespace vesicle
{
namespace
{

const std::string scenes = "scenes/", scene_ending = ".toml";

struct NewOptions
{
  std::string name;
  std::string file;
};

std::vector<std::string> template_names()
{
  std::vector<std::string> names;
  for (const std::string& file : data_files(scenes))
  {
    names.push_back(file.substr(scenes.size(), file.size() - scenes.size() - scene_ending.size()));
  }
  return names;
}

/// The first sentence of the comment that a scene begins with.
std::string first_sentence(const std::string& scene)
{
  std::istringstream lines(scene);
  std::string text;
  for (std::string line; std::getline(lines, line) && line.starts_with("# ");)
  {
    text += (text.empty() ? "" : " ") + line.substr(2);
  }
  text += ' ';
  return text.substr(0, std::min(text.find(". "), text.find(": ")));
}

int list_templates()
{
  for (const std::string& name : template_names())
  {
    print("{:<20} {}\n", name, first_sentence(data_file(scenes + name + scene_ending)));
  }
  return exit_code::done;
}

const std::string& template_text(const std::string& name)
{
  const auto names = template_names();
  if (std::find(names.begin(), names.end(), name) == names.end())
  {
    const std::string nearest = nearest_name(name, names);
    throw InputError(fmt::format("there is no template '{}'{}; templates: {}", name,
      nearest.empty() ? "" : fmt::format(", did you mean '{}'?", nearest), joined(names, " ")));
  }
  return data_file(scenes + name + scene_ending);
}

int write_template(const NewOptions& options)
{
  const std::string& text = template_text(options.name);
  if (options.file.empty())
  {
    print("{}", text);
  }
  else if (is_there(options.file))
  {
    throw InputError(options.file + ": is there already; remove it, or choose another file by -o");
  }
  else
  {
    replace_file(options.file, text);
  }
  const Scene scene = parse_scene(text, options.name);
  if (scene.vesicle.mesh_file)
  {
    warn(options.name + ": this scene starts from a mesh: give yours as vesicle.file");
  }
  if (scene.flow && is_from_file(scene.flow->kind()))
  {
    warn(options.name + ": this scene's flow comes from a file: give yours as flow.file");
  }
  return exit_code::done;
}

}

void add_new_command(CLI::App& app, Action& action)
{
  auto options = std::make_shared<NewOptions>();
  auto* command = app.add_subcommand("new", "A scene to start your own from");
  command->add_option("template", options->name, "Which; all are listed if left out");
  command->add_option("-o,--output", options->file,
    "File to write, never one that is there; standard output if left out");
  command->footer("Example: vesicle new pear > scene.toml");
  command->callback(
    [options, &action]
    {
      action = [options]
      { return options->name.empty() ? list_templates() : write_template(*options); };
    });
}

}
