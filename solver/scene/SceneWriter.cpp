// Writing a Scene as TOML: the inverse of SceneFile.cpp.

#include "solver/scene/SceneFile.h"
#include "solver/scene/SceneSchema.h"

#include <fmt/format.h>

namespace vesicle
{
namespace
{

std::string table_text(const SceneTable& table, const Scene& scene)
{
  std::string text = table.name.empty() ? "" : fmt::format("\n[{}]\n", table.name);
  const std::string variant = table.variant_of ? table.variant_of(scene) : "";
  for (const SceneKey& key : table.keys)
    if (key.goes_with(variant) && (!key.shown || key.shown(scene)))
    {
      const std::string value = key.write(scene);
      if (!value.empty())
        text += fmt::format("{} = {}\n", key.name, value);
    }
  return text;
}

}

std::string write_scene(const Scene& scene)
{
  std::string text;
  for (const SceneTable& table : scene_schema())
    if (!table.present || table.present(scene))
      text += table_text(table, scene);
  return text;
}

}
