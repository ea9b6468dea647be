// Writing a Scene as TOML: the inverse of SceneFile.cpp.

#include "solver/scene/SceneWriter.h"

#include "solver/scene/SceneDocument.h"
#include "solver/scene/SceneFile.h"
#include "solver/scene/SceneSchema.h"

#include <fmt/format.h>

#include <algorithm>

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

std::string keys_text(
  const SceneTable& table, const Scene& scene, const KeyRemark& remark, std::size_t vesicle)
{
  std::string text;
  const std::string variant = table.variant_of ? table.variant_of(scene) : "";
  for (const SceneKey& key : table.keys)
    if (key.goes_with(variant) && (!key.shown || key.shown(scene)))
    {
      const std::string value = key.write(scene);
      const auto said = value.empty() ? std::nullopt : remark(table, key, vesicle);
      if (said)
        text += line_of(fmt::format("{} = {}", key.name, value), *said);
    }
  return text;
}

std::string nothing(const SceneTable&, const SceneKey&, std::size_t)
{
  return {};
}

/// Whether a preset says what the key is where a scene doesn't.
bool is_of_preset(const SceneTable& table, const SceneKey& key)
{
  return table.name == "accuracy" ? key.name != "preset"
                                  : table.name == "time" && key.name == "tolerance";
}

/// The tables of a vesicle beside the first, where they aren't as the first's: a whole table each.
std::string own_tables_text(Scene first, Scene own, const KeyRemark& remark, std::size_t vesicle)
{
  for (Scene* scene : { &first, &own })
    if (!scene->gravity)
      scene->gravity = Scene::Gravity{ 0., 0, 0 };
  own.fluid.viscosity = first.fluid.viscosity;
  std::string text;
  for (const SceneTable& table : scene_schema())
  {
    const bool may = std::ranges::find(own_tables(), table.name) != own_tables().end();
    if (!may || keys_text(table, own, nothing, 0) == keys_text(table, first, nothing, 0))
      continue;
    SceneTable rest = table;
    std::erase_if(
      rest.keys, [&](const SceneKey& key) { return is_of_the_scene(table.name, key.name); });
    text += fmt::format("\n[vesicle.{}]\n{}", table.name, keys_text(rest, own, remark, vesicle));
  }
  return text;
}

std::string vesicles_text(const SceneTable& table, const Scene& scene, const KeyRemark& remark)
{
  std::string text;
  const Scene first = scene.alone(0);
  for (std::size_t v = 0; v < scene.vesicles(); ++v)
  {
    const Scene own = scene.alone(v);
    text += fmt::format("\n[[{}]]\n{}", table.name, keys_text(table, own, remark, v));
    text += own_tables_text(first, own, remark, v);
  }
  return text;
}

std::string table_text(const SceneTable& table, const Scene& scene, const KeyRemark& remark)
{
  if (table.name == "vesicle" && scene.vesicles() > 1)
    return vesicles_text(table, scene, remark);
  return (table.name.empty() ? "" : fmt::format("\n[{}]\n", table.name)) +
    keys_text(table, scene, remark, 0);
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
  return write_scene(scene, nothing);
}

std::string write_editable_scene(const Scene& scene)
{
  Scene by_preset = scene;
  by_preset.accuracy = Scene::preset(scene.accuracy.preset);
  by_preset.time.tolerance = Scene::preset_tolerance(scene.accuracy.preset);
  return write_scene(scene,
    [&](const SceneTable& table, const SceneKey& key, std::size_t)
    {
      const bool implied = is_of_preset(table, key) && key.write(scene) == key.write(by_preset);
      return implied ? std::nullopt : std::optional<std::string>("");
    });
}

}
