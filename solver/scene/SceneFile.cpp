#include "solver/scene/SceneFile.h"

#include "solver/Errors.h"
#include "solver/Joined.h"
#include "solver/files/FileBytes.h"
#include "solver/mesh/io/TextScanner.h"
#include "solver/scene/NearestName.h"
#include "solver/scene/SceneDocument.h"
#include "solver/scene/Quantity.h"
#include "solver/scene/SceneSchema.h"
#include "solver/scene/SceneUnits.h"
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

Scene read_vesicle(const SceneDocument& document)
{
  Scene scene;
  for (const SceneTable& table : scene_schema())
    read_table(document, table, scene);
  return scene;
}

/// What there is for a single vesicle only.
void check_several(const SceneDocument& document, const Scene& scene)
{
  const auto refuse =
    [&](const char* table, const char* key, const std::string& problem, const char* allowed)
  {
    TableReader(document, table)
      .fail(key, fmt::format("{}, and there are {}", problem, scene.vesicles()), allowed);
  };
  if (scene.time.equilibrium)
    refuse("time", "end", "an equilibrium is that of one vesicle", "a time, or \"steady\"");
  if (scene.accuracy.mesh_motion == Scene::MeshMotion::adaptive)
    refuse("accuracy", "mesh_motion", "\"adaptive\" lays the mesh of one vesicle anew",
      "\"equidistribute\", \"material\"");
  if (scene.accuracy.basis != Scene::Basis::loop)
    refuse("accuracy", document.find("accuracy", "basis") ? "basis" : "preset",
      "flat triangles feel one vesicle only", "\"balanced\" or \"accurate\", or basis = \"loop\"");
}

Scene read_document(const SceneDocument& document)
{
  check_tables(document);
  Scene scene = read_vesicle(document.of_vesicle(0));
  for (std::size_t v = 1; v < document.vesicles.size(); ++v)
    scene.companions.push_back(read_vesicle(document.of_vesicle(v)).companion());
  if (!scene.companions.empty())
    check_several(document, scene);
  else if (scene.interaction)
    TableReader(document, "interaction")
      .fail("repulsion", "is between vesicles, and there is one", "several [[vesicle]] tables");
  return scene;
}

SceneDocument parsed(const std::string& text, const std::string& name,
  const std::filesystem::path& folder, const std::vector<std::string>& overrides)
{
  SceneDocument document = parse_document(text, name, folder, overrides);
  convert_units(document);
  return document;
}

SceneDocument document_of(
  const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
  return parsed(read_file(file), file.string(), file.parent_path(), overrides);
}

/// The value of a key that is a number in SI, with a unit that people use; empty for others.
std::string measured(const SceneKey& key, const Scene& scene)
{
  const Dimensions dimensions = dimensions_of(key.unit);
  if (scene.units != Units::si || dimensions.size() != 1)
    return {};
  const auto value = number_of<double>(key.write(scene));
  return value ? quantity_text(*value, dimensions.front()) : "";
}

/// A missing mesh is better said here, with the scene's line, than when it is read.
void check_meshes_exist(const SceneDocument& document, const Scene& scene)
{
  for (std::size_t v = 0; v < scene.vesicles(); ++v)
  {
    const auto& mesh = v == 0 ? scene.vesicle.mesh_file : scene.companions[v - 1].vesicle.mesh_file;
    if (mesh && !is_there(*mesh))
    {
      const SceneDocument own = document.of_vesicle(v);
      TableReader(own, "vesicle")
        .fail("file", fmt::format("there is no {}", mesh->string()),
          "the path of a mesh, relative to the scene's folder or absolute");
    }
  }
}

}

Scene read_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
  const SceneDocument document = document_of(file, overrides);
  Scene scene = read_document(document);
  check_meshes_exist(document, scene);
  scene.file = std::filesystem::absolute(file).lexically_normal();
  return scene;
}

Scene parse_scene(const std::string& text, const std::string& name,
  const std::filesystem::path& folder, const std::vector<std::string>& overrides)
{
  return read_document(parsed(text, name, folder, overrides));
}

std::string annotated_scene(
  const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
  const SceneDocument document = document_of(file, overrides);
  std::vector<SceneDocument> of_vesicles;
  for (std::size_t v = 0; v < document.vesicles.size(); ++v)
    of_vesicles.push_back(document.of_vesicle(v));
  const Scene scene = read_document(document);
  const auto remark = [&](const SceneTable& table, const SceneKey& key, std::size_t vesicle)
  {
    const bool given = of_vesicles[vesicle].find(table.name, key.name);
    return joined_said(
      { key.unit, measured(key, scene.alone(vesicle)), given ? "" : "by default" }, "; ");
  };
  return write_scene(scene, remark);
}

}
