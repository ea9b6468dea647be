#include "solver/scene/SceneFile.h"

#include "solver/Errors.h"
#include "solver/Joined.h"
#include "solver/files/FileBytes.h"
#include "solver/scene/NearestName.h"
#include "solver/scene/SceneDocument.h"
#include "solver/scene/SceneSchema.h"
#include "solver/scene/SceneWriter.h"
#include "solver/scene/TableReader.h"

#include <fmt/format.h>

#include <algorithm>

namespace vesicle
{
namespace
{

/// The names of the tables, without the top.
std::vector<std::string> table_names()
{
  std::vector<std::string> names;
  for (const SceneTable& table : scene_schema())
    if (!table.name.empty())
      names.push_back(table.name);
  return names;
}

/// Refuses what is neither a table of the schema nor a key at the top.
void check_tables(const SceneDocument& document)
{
  const TableReader top(document, "");
  const std::vector<std::string> names = table_names();
  const auto known = [&](const std::string& name)
  { return std::find(names.begin(), names.end(), name) != names.end(); };

  for (const auto& entry : document.entries)
    if (entry.table.empty() && known(entry.key))
      top.fail(
        entry.key, "must be a table, is " + entry.value.description(), "[" + entry.key + "]");
  for (const auto& table : document.tables)
    if (!known(table.name))
    {
      const std::string nearest = nearest_name(table.name, names);
      top.fail_at(table.where, table.name,
        "unknown table" + (nearest.empty() ? "" : fmt::format(", did you mean [{}]?", nearest)),
        fmt::format("name, [{}]", joined(names, "], [")));
    }
  std::vector<std::string> keys = scene_schema().front().names();
  for (const auto& name : names)
    keys.push_back("[" + name + "]");
  top.check_keys(keys);
}

void read_table(const SceneDocument& document, const SceneTable& table, Scene& scene)
{
  const TableReader reader(document, table.name);
  if (table.present && !reader.given())
    return;
  const auto variant = table.variant_in ? table.variant_in(table, reader) : SceneTable::Variant{};
  if (!table.name.empty())
    reader.check_keys(table.names(variant.name), table.names(), variant.because);
  const auto goes_with_it = [&](const SceneKey& key) { return key.goes_with(variant.name); };
  for (const SceneKey& key : table.keys)
    if (goes_with_it(key) && key.is_needed_by(variant.name))
      reader.require(key.name, *key.missing);
  if (table.create)
    table.create(scene);
  for (const SceneKey& key : table.keys)
  {
    if (goes_with_it(key) && reader.has(key.name))
      key.read(reader, scene);
    if (key.then)
      key.then(document, scene);
  }
  if (table.check)
    table.check(reader, scene);
}

Scene read_document(const SceneDocument& document)
{
  Scene scene;
  check_tables(document);
  for (const SceneTable& table : scene_schema())
    read_table(document, table, scene);
  return scene;
}

SceneDocument document_of(
  const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
  return parse_document(read_file(file), file.string(), file.parent_path(), overrides);
}

/// A missing mesh is better said here, with the scene's line, than when it is read.
void check_mesh_exists(const SceneDocument& document, const Scene& scene)
{
  if (scene.vesicle.mesh_file && !is_there(*scene.vesicle.mesh_file))
    TableReader(document, "vesicle")
      .fail("file", fmt::format("there is no {}", scene.vesicle.mesh_file->string()),
        "the path of a mesh, relative to the scene's folder or absolute");
}

}

Scene read_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
  const SceneDocument document = document_of(file, overrides);
  Scene scene = read_document(document);
  check_mesh_exists(document, scene);
  scene.file = std::filesystem::absolute(file).lexically_normal();
  return scene;
}

Scene parse_scene(const std::string& text, const std::string& name,
  const std::filesystem::path& folder, const std::vector<std::string>& overrides)
{
  return read_document(parse_document(text, name, folder, overrides));
}

std::string annotated_scene(
  const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
  const SceneDocument document = document_of(file, overrides);
  const auto remark = [&](const SceneTable& table, const SceneKey& key)
  {
    const std::string origin = document.find(table.name, key.name) ? "" : "by default";
    return origin.empty() || key.unit.empty() ? origin + key.unit : key.unit + "; " + origin;
  };
  return write_scene(read_document(document), remark);
}

}
