#include "apps/RunBeside.h"

#include "solver/Errors.h"
#include "solver/files/FileBytes.h"
#include "solver/scene/SceneFile.h"

#include <nlohmann/json.hpp>

#include <fstream>

namespace vesicle
{
namespace
{

using std::filesystem::path;

/// pear of pear.pvd and pear.vtu.series.
std::string run_name(const path& series)
{
  path name = series.filename();
  while (name.extension() == ".series" || name.extension() == ".vtu" || name.extension() == ".pvd")
  {
    name = name.stem();
  }
  return name.string();
}

std::optional<Scene> scene_of(const path& summary)
{
  std::ifstream in(summary);
  const auto json = nlohmann::ordered_json::parse(in, nullptr, false);
  if (!json.is_object() || !json.contains("settings") || !json["settings"].is_string())
  {
    return std::nullopt;
  }
  try
  {
    return parse_scene(json["settings"].get<std::string>(), summary.string());
  }
  catch (const InputError&) // of another version: the pictures can do without
  {
    return std::nullopt;
  }
}

}

RunBeside run_beside(const path& series)
{
  RunBeside beside;
  const path folder = series.parent_path();
  const std::string name = run_name(series);
  auto scene = scene_of(folder / "summary.json");
  if (scene && scene->name == name)
  {
    beside.scene = std::move(scene);
  }
  const path table = folder / (name + ".csv");
  if (is_there(table))
  {
    beside.table = read_run_table(table);
  }
  return beside;
}

}
