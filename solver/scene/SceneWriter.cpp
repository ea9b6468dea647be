// Writing a Scene as TOML: the inverse of SceneFile.cpp.

#include "solver/scene/SceneWriter.h"

#include "solver/scene/SceneFile.h"
#include "solver/scene/SceneSchema.h"

#include <fmt/format.h>

namespace vesicle
{
namespace
{

constexpr int remark_column = 36;

std::string line_of(const std::string& setting, const std::string& remark)
{
  return remark.empty() ? setting + '\n'
                        : fmt::format("{:<{}} # {}\n", setting, remark_column, remark);
}

std::string table_text(const SceneTable& table, const Scene& scene, const KeyRemark& remark)
{
  std::string text = table.name.empty() ? "" : fmt::format("\n[{}]\n", table.name);
  const std::string variant = table.variant_of ? table.variant_of(scene) : "";
  for (const SceneKey& key : table.keys)
    if (key.goes_with(variant) && (!key.shown || key.shown(scene)))
    {
      const std::string value = key.write(scene);
      if (!value.empty())
        text += line_of(fmt::format("{} = {}", key.name, value), remark(table, key));
    }
  return text;
}

}

std::string write_scene(const Scene& scene, const KeyRemark& remark)
{
  std::string text;
  for (const SceneTable& table : scene_schema())
    if (!table.present || table.present(scene))
      text += table_text(table, scene, remark);
  return text;
}

std::string write_scene(const Scene& scene)
{
  return write_scene(scene, [](const SceneTable&, const SceneKey&) { return std::string(); });
}

}
