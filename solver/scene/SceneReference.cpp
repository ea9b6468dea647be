#include "solver/scene/SceneReference.h"

#include "solver/Joined.h"
#include "solver/scene/SceneSchema.h"

#include <fmt/format.h>

namespace vesicle
{
namespace
{

/// As it may stand in a row of a Markdown table.
std::string in_cell(const std::string& text)
{
  std::string escaped;
  for (const char c : text)
  {
    if (c == '|')
      escaped += '\\';
    escaped += c;
  }
  return escaped;
}

/// The scene that has the table in one of the key's variants, all else by default.
Scene example(const SceneTable& table, const SceneKey& key)
{
  Scene scene;
  if (table.create)
    table.create(scene);
  if (table.make_example && !table.variants.empty())
    table.make_example(
      scene, key.variants.empty() ? table.variants.front().first : key.variants.front());
  return scene;
}

/// What a key is where a scene says nothing.
std::string default_of(const SceneTable& table, const SceneKey& key)
{
  if (key.missing && key.needed_by.empty())
    return "required";
  if (key.missing && table.variants.empty())
    return key.left_out.empty()
      ? "—"
      : key.left_out; // one or another must be given, as the table's help says
  const std::string text =
    key.left_out.empty() ? fmt::format("`{}`", key.write(example(table, key))) : key.left_out;
  return key.missing ? fmt::format("{}; required by {}", text, joined(key.needed_by, ", ")) : text;
}

/// By name, or all but some where these are fewer.
std::string variants_of(const SceneTable& table, const SceneKey& key)
{
  std::vector<std::string> with, without;
  for (const auto& [name, help] : table.variants)
    (key.goes_with(name) ? with : without).push_back(name);
  if (without.empty())
    return "all";
  return without.size() < with.size() ? "all but " + joined(without, ", ") : joined(with, ", ");
}

std::string row(const SceneTable& table, const SceneKey& key)
{
  std::vector<std::string> cells{ fmt::format("`{}`", key.name) };
  if (!table.variants.empty())
    cells.push_back(variants_of(table, key));
  for (const std::string& cell :
    { key.allowed, default_of(table, key), key.unit.empty() ? "—" : key.unit, key.help })
    cells.push_back(in_cell(cell));
  return fmt::format("| {} |\n", joined(cells, " | "));
}

std::string section(const SceneTable& table)
{
  std::string text = table.name.empty() ? "" : fmt::format("\n## [{}]\n", table.name);
  text += fmt::format("\n{}\n", table.help);
  for (const auto& [name, help] : table.variants)
    text +=
      fmt::format("{}- `{}`: {}\n", &name == &table.variants.front().first ? "\n" : "", name, help);
  const bool variants = !table.variants.empty();
  text += variants
    ? "\n| key | goes with | value | default | unit | meaning |\n|---|---|---|---|---|---|\n"
    : "\n| key | value | default | unit | meaning |\n|---|---|---|---|---|\n";
  for (const SceneKey& key : table.keys)
    text += row(table, key);
  return text;
}

}

std::string scene_reference()
{
  std::string text =
    "# Scenes: every key\n\n"
    "A scene is a TOML file; data/scenes holds examples. Units are yours, as long as they go "
    "together: all numbers\n"
    "of order 1, or SI. An unknown key, a missing one, a wrong type or an impossible value is an "
    "error that names\n"
    "the line and says what is allowed. `--set table.key=value` changes a key for one run.\n\n"
    "This page is what the program's own table of keys says: `bin/scene_reference > "
    "docs/scenes-reference.md` writes it anew.\n";
  for (const SceneTable& table : scene_schema())
    text += section(table);
  return text;
}

}
