#include "solver/scene/SceneFile.h"

#include "solver/Errors.h"
#include "solver/flow/FlowKinds.h"
#include "solver/scene/NearestName.h"
#include "solver/scene/SceneDocument.h"
#include "solver/scene/TableReader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <system_error>

namespace vesicle
{
namespace
{

using Keys = std::vector<std::string>;

constexpr NumberRule fraction{ [](double x) { return x > 0 && x <= 1; },
  "a number > 0 and <= 1 (1 is a sphere)" };
constexpr NumberRule below_one{ [](double x) { return x > 0 && x < 1; }, "a number > 0 and < 1" };
constexpr IntegerRule triangle_count{ [](int n) { return n >= 20 && n <= 5'000'000; },
  "an integer from 20 (an icosahedron) to 5000000" };
constexpr IntegerRule quadrature_points{
  [](int n) { return n == 1 || n == 3 || n == 6 || n == 12; }, "1, 3, 6, 12"
};
constexpr IntegerRule degree{ [](int l) { return l >= 0; }, "an integer >= 0" };
constexpr IntegerRule any_integer{ [](int) { return true; }, "an integer" };
constexpr IntegerRule pixels{ [](int n) { return n >= 16 && n <= 16384; },
  "an integer from 16 to 16384" };

/// Keys that every choice has, and those that go with one choice only.
struct KeysByChoice
{
  Keys common;
  std::map<std::string, Keys> own;

  Keys of(const std::string& choice) const
  {
    Keys keys = common;
    const auto& more = own.at(choice);
    keys.insert(keys.end(), more.begin(), more.end());
    return keys;
  }
  Keys all() const
  {
    Keys keys = common;
    for (const auto& [choice, more] : own)
    {
      keys.insert(keys.end(), more.begin(), more.end());
    }
    return keys;
  }
};

const KeysByChoice shape_keys{ { "shape", "radius", "triangles", "axis", "rotation", "center" },
  {
    { "sphere", { "reduced_volume" } },
    { "prolate", { "reduced_volume" } },
    { "oblate", { "reduced_volume" } },
    { "ellipsoid", { "semi_axes", "reduced_volume" } },
    { "discocyte", { "reduced_volume" } },
    { "perturbed", { "modes" } },
  } };
const Keys mesh_keys{ "file", "radius", "triangles", "rotation" };

Keys known_vesicle_keys()
{
  Keys keys = shape_keys.all();
  keys.push_back("file");
  return keys;
}

std::vector<std::string> shape_words()
{
  std::vector<std::string> words;
  for (const auto kind : shape_kinds)
  {
    words.push_back(shape_name(kind));
  }
  return words;
}

void read_rotation(const TableReader& table, Scene::Vesicle& vesicle)
{
  table.read("rotation", vesicle.rotation, any_number);
  if (!vesicle.rotation)
  {
    return;
  }
  auto& rotation = *vesicle.rotation;
  const Vector3 axis(rotation[0], rotation[1], rotation[2]);
  if (axis.isZero(0))
  {
    table.fail("rotation", "its axis can't be the zero vector",
      "[axis x, y, z, degrees], the axis not all 0");
  }
  const Vector3 unit = unit_direction(axis);
  rotation = { unit[0], unit[1], unit[2], rotation[3] };
}

void read_modes(const TableReader& table, std::vector<ShapeMode>& modes)
{
  const std::string allowed =
    "[[l, m, amplitude], …] with integers l >= 0 and |m| <= l, amplitude in units of the radius";
  table.require("modes", allowed);
  for (const auto& item : table.items("modes", table.at("modes"), 0, allowed))
  {
    const auto& values = table.items("modes", item, 3, allowed);
    ShapeMode mode;
    mode.l = table.integer("modes", values[0], degree);
    mode.m = table.integer("modes", values[1], any_integer);
    mode.amplitude = table.number("modes", values[2], any_number);
    if (std::abs(static_cast<double>(mode.m)) > mode.l)
    {
      table.fail_at(
        item.where, "modes", fmt::format("can't have m = {} with l = {}", mode.m, mode.l), allowed);
    }
    modes.push_back(mode);
  }
  if (modes.empty())
  {
    table.fail("modes", "can't be empty", allowed);
  }
}

void read_shape(const TableReader& table, Scene::Vesicle& vesicle)
{
  std::string word;
  table.read("shape", word, shape_words());
  table.check_keys(shape_keys.of(word), known_vesicle_keys(), fmt::format("shape = \"{}\"", word));

  ShapeRequest& shape = vesicle.shape;
  shape.kind = shape_kind(word);
  if (shape.kind == ShapeRequest::Kind::prolate || shape.kind == ShapeRequest::Kind::oblate)
  {
    table.require("reduced_volume", fraction.allowed);
  }
  if (shape.kind == ShapeRequest::Kind::ellipsoid)
  {
    table.require("semi_axes", "[a, b, c], each a number > 0");
  }
  if (shape.kind == ShapeRequest::Kind::perturbed)
  {
    read_modes(table, shape.modes);
  }
  if (table.has("axis") && table.has("rotation"))
  {
    table.fail(
      "rotation", "contradicts 'axis': a shape is turned by one of them", "rotation or axis");
  }
  table.read("triangles", shape.triangles, triangle_count);
  table.read("reduced_volume", shape.reduced_volume, fraction);
  if (shape.kind == ShapeRequest::Kind::sphere && shape.reduced_volume.value_or(1) != 1)
  {
    table.fail("reduced_volume", "does not go with shape = \"sphere\"", "1, or another shape");
  }
  table.read("semi_axes", shape.semi_axes, positive);
  table.read("radius", vesicle.radius, positive);
  table.read_direction("axis", vesicle.axis);
  table.read("center", vesicle.center);
}

void read_mesh_file(
  const TableReader& table, const std::filesystem::path& folder, Scene::Vesicle& vesicle)
{
  if (table.has("shape"))
  {
    table.fail("file", "contradicts 'shape': the vesicle starts from one of them", "file or shape");
  }
  table.check_keys(mesh_keys, known_vesicle_keys(), "'file'");
  std::string file;
  table.read("file", file);
  if (file.empty())
  {
    table.fail("file", "can't be empty", "the path of a mesh");
  }
  vesicle.mesh_file = std::filesystem::absolute(folder / file).lexically_normal();
  table.read("radius", vesicle.mesh_radius, positive);
  table.read("triangles", vesicle.mesh_triangles, triangle_count);
}

void read_vesicle(
  const SceneDocument& document, const std::filesystem::path& folder, Scene::Vesicle& vesicle)
{
  const TableReader table(document, "vesicle");
  if (!table.has("shape") && !table.has("file"))
  {
    Keys keys = known_vesicle_keys();
    table.check_keys(keys);
    table.fail("shape", "is missing",
      fmt::format("\"{}\", or 'file' with a mesh", fmt::join(shape_words(), "\", \"")));
  }
  if (table.has("file"))
  {
    read_mesh_file(table, folder, vesicle);
  }
  else
  {
    read_shape(table, vesicle);
  }
  read_rotation(table, vesicle);
}

void read_membrane(const SceneDocument& document, Scene::Membrane& membrane)
{
  const TableReader table(document, "membrane");
  table.check_keys({ "bending_rigidity", "incompressible" });
  table.read("bending_rigidity", membrane.bending_rigidity,
    NumberRule{ positive.holds, "a number > 0; leave the key out for no bending" });
  table.read("incompressible", membrane.incompressible);
}

void read_fluid(const SceneDocument& document, Scene::Fluid& fluid)
{
  const TableReader table(document, "fluid");
  table.check_keys({ "viscosity" });
  table.read("viscosity", fluid.viscosity, positive);
}

/// The kinds that a scene calls `name`.
std::vector<const FlowKind*> kinds_named(const std::string& name)
{
  std::vector<const FlowKind*> kinds;
  for (const FlowKind* kind : flow_kinds())
    if (kind->name == name)
      kinds.push_back(kind);
  return kinds;
}

std::vector<std::string> flow_names()
{
  std::vector<std::string> names;
  for (const FlowKind* kind : flow_kinds())
    if (names.empty() || names.back() != kind->name)
      names.push_back(kind->name);
  return names;
}

Keys flow_keys(const FlowKind& kind)
{
  Keys keys{ "kind" };
  for (const FlowParameter& parameter : kind.parameters)
    keys.push_back(parameter.name);
  if (!kind.type.empty())
    keys.push_back("type");
  return keys;
}

Keys all_flow_keys()
{
  Keys keys;
  for (const FlowKind* kind : flow_kinds())
    for (const std::string& key : flow_keys(*kind))
      if (std::find(keys.begin(), keys.end(), key) == keys.end())
        keys.push_back(key);
  return keys;
}

/// The kind among those of one name that the scene's `type` chooses.
const FlowKind& read_flow_type(
  const TableReader& table, const std::vector<const FlowKind*>& candidates)
{
  if (candidates.front()->type.empty())
    return *candidates.front();
  std::vector<std::string> types, described;
  for (const FlowKind* kind : candidates)
  {
    types.push_back(kind->type);
    described.push_back(fmt::format("\"{}\" ({})", kind->type, kind->axes));
  }
  table.require("type", fmt::format("{}", fmt::join(described, ", ")));
  std::string type;
  table.read("type", type, types);
  return *candidates[std::find(types.begin(), types.end(), type) - types.begin()];
}

std::string wanted(const FlowParameter& parameter)
{
  if (!parameter.missing.empty())
    return parameter.missing;
  if (std::holds_alternative<Vector3 ImposedFlow::*>(parameter.member))
    return "[x, y, z]";
  return parameter.positive ? positive.allowed : any_number.allowed;
}

void read_parameter(const TableReader& table, const FlowParameter& parameter, double& number)
{
  table.read(parameter.name, number, parameter.positive ? positive : any_number);
}

void read_parameter(const TableReader& table, const FlowParameter& parameter, Vector3& vector)
{
  if (parameter.dimension == Dimension::direction)
    table.read_direction(parameter.name, vector);
  else
    table.read(parameter.name, vector);
}

void read_flow(const SceneDocument& document, std::shared_ptr<const ImposedFlow>& flow)
{
  const TableReader table(document, "flow");
  if (!table.given())
    return;
  if (!table.has("kind"))
  {
    table.check_keys(all_flow_keys());
    table.fail("kind", "is missing", fmt::format("\"{}\"", fmt::join(flow_names(), "\", \"")));
  }
  std::string name;
  table.read("kind", name, flow_names());
  const auto candidates = kinds_named(name);
  table.check_keys(
    flow_keys(*candidates.front()), all_flow_keys(), fmt::format("kind = \"{}\"", name));
  for (const FlowParameter& parameter : candidates.front()->parameters)
    if (parameter.required)
      table.require(parameter.name, wanted(parameter));
  const FlowKind& kind = read_flow_type(table, candidates);
  const std::shared_ptr<ImposedFlow> read = kind.make();
  for (const FlowParameter& parameter : kind.parameters)
    std::visit(
      [&](auto member) { read_parameter(table, parameter, (*read).*member); }, parameter.member);
  flow = read;
}

void read_gravity(const SceneDocument& document, std::optional<Scene::Gravity>& gravity)
{
  const TableReader table(document, "gravity");
  if (!table.given())
  {
    return;
  }
  table.check_keys({ "bond_number", "density_difference", "acceleration" });
  const std::string allowed = "bond_number, or both density_difference and acceleration";
  const bool dimensional = table.has("density_difference") || table.has("acceleration");
  if (table.has("bond_number") && dimensional)
  {
    table.fail("bond_number", "contradicts 'density_difference' and 'acceleration'", allowed);
  }
  gravity.emplace();
  if (dimensional)
  {
    table.require("density_difference", allowed);
    table.require("acceleration", allowed);
  }
  else
  {
    table.require("bond_number", allowed);
  }
  table.read("bond_number", gravity->bond_number, any_number);
  table.read("density_difference", gravity->density_difference, any_number);
  table.read("acceleration", gravity->acceleration, any_number);
}

void read_time(const SceneDocument& document, Scene::Time& time, Scene::Preset preset)
{
  const TableReader table(document, "time");
  table.check_keys({ "end", "output_every", "step", "tolerance" });
  table.require("end", "a number > 0 or \"steady\"");
  table.require("output_every", positive.allowed);
  time.tolerance = Scene::preset_tolerance(preset);
  table.read_unless("end", "steady", time.end, positive);
  table.read("output_every", time.output_every, positive);
  table.read_unless("step", "auto", time.step, positive);
  table.read("tolerance", time.tolerance, positive);
}

void read_accuracy(const SceneDocument& document, Scene::Accuracy& accuracy)
{
  const TableReader table(document, "accuracy");
  table.check_keys({ "preset", "basis", "bending", "integrator", "mesh_motion", "operator",
    "quadrature", "linear_tolerance", "precision" });
  table.read("preset", accuracy.preset, preset_names);
  accuracy = Scene::preset(accuracy.preset);
  table.read("basis", accuracy.basis, basis_names);
  accuracy.bending = Scene::bending_of(accuracy.basis);
  table.read("bending", accuracy.bending, bending_names);
  table.read("integrator", accuracy.integrator, integrator_names);
  table.read("mesh_motion", accuracy.mesh_motion, mesh_motion_names);
  table.read("operator", accuracy.stokes_operator, operator_names);
  table.read("quadrature", accuracy.quadrature, quadrature_points);
  table.read("linear_tolerance", accuracy.linear_tolerance, below_one);
  table.read("precision", accuracy.precision, precision_names);
  if (accuracy.scheme == Scene::Scheme::paper && accuracy.basis != Scene::Basis::linear)
  {
    table.fail("basis", "the paper's scheme is one of linear elements", "\"linear\"");
  }
  if (accuracy.bending != Scene::bending_of(accuracy.basis))
  {
    table.fail("bending", "doesn't go with the basis",
      "\"cotan\" with basis \"linear\", \"variational\" with \"loop\"");
  }
}

void read_movie(const SceneDocument& document, Scene::Movie& movie)
{
  const TableReader table(document, "movie");
  table.check_keys(
    { "color", "range", "size", "view", "camera", "smooth", "arrows", "edges", "chart" });
  table.read("color", movie.color, field_names);
  table.read("range", movie.range, any_number);
  if (movie.range && !((*movie.range)[0] < (*movie.range)[1]))
  {
    table.fail("range", "its first number must be below its second", "[a, b] with a < b");
  }
  if (table.has("size"))
  {
    const std::string allowed = std::string("[width, height], each ") + pixels.allowed;
    const auto& size = table.items("size", table.at("size"), 2, allowed);
    movie.size = { table.integer("size", size[0], pixels), table.integer("size", size[1], pixels) };
  }
  table.read("view", movie.view, view_names);
  table.read("camera", movie.camera, camera_names);
  table.read("smooth", movie.smooth);
  table.read("arrows", movie.arrows);
  table.read("edges", movie.edges);
  table.read("chart", movie.chart, chart_names);
}

void read_output(
  const SceneDocument& document, const std::filesystem::path& folder, Scene::Output& output)
{
  const TableReader table(document, "output");
  table.check_keys({ "fields", "directory" });
  table.read("fields", output.fields, field_names);
  if (!table.has("directory"))
  {
    return;
  }
  std::string directory;
  table.read("directory", directory);
  if (directory.empty())
  {
    table.fail("directory", "can't be empty", "the path of a folder");
  }
  output.directory = std::filesystem::absolute(folder / directory).lexically_normal();
}

const Keys table_names{ "vesicle", "membrane", "fluid", "flow", "gravity", "time", "accuracy",
  "movie", "output" };

/// The tables, and at the top nothing but `name`.
void check_tables(const SceneDocument& document)
{
  const TableReader top(document, "");
  const std::string allowed = fmt::format("name, [{}]", fmt::join(table_names, "], ["));
  const auto known = [](const std::string& name)
  { return std::find(table_names.begin(), table_names.end(), name) != table_names.end(); };

  for (const auto& entry : document.entries)
  {
    if (entry.table.empty() && known(entry.key))
    {
      top.fail(
        entry.key, "must be a table, is " + entry.value.description(), "[" + entry.key + "]");
    }
  }
  for (const auto& table : document.tables)
  {
    if (!known(table.name))
    {
      const std::string nearest = nearest_name(table.name, table_names);
      top.fail_at(table.where, table.name,
        "unknown table" + (nearest.empty() ? "" : fmt::format(", did you mean [{}]?", nearest)),
        allowed);
    }
  }
  Keys keys{ "name" };
  for (const auto& name : table_names)
  {
    keys.push_back("[" + name + "]");
  }
  top.check_keys(keys);
}

bool usable_in_file_names(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
    c == '.' || c == '-';
}

/// The name of a scene that gives none: its file's without the ending.
std::string default_name(const std::string& file)
{
  std::string name = std::filesystem::path(file).stem().string();
  std::replace_if(
    name.begin(), name.end(), [](char c) { return !usable_in_file_names(c); }, '-');
  return name.empty() || name == "." || name == ".." ? "vesicle" : name;
}

/// The name becomes that of folders and files.
void read_name(const SceneDocument& document, std::string& name)
{
  const TableReader top(document, "");
  name = default_name(document.name);
  top.read("name", name);
  const bool usable = !name.empty() && name != "." && name != ".." &&
    std::all_of(name.begin(), name.end(), usable_in_file_names);
  if (!usable)
  {
    top.fail("name", fmt::format("\"{}\" can't be used as a file name", name),
      "letters, digits, '_', '.', '-'");
  }
}

Scene read_document(const SceneDocument& document, const std::filesystem::path& folder)
{
  Scene scene;
  check_tables(document);
  read_name(document, scene.name);
  read_vesicle(document, folder, scene.vesicle);
  read_membrane(document, scene.membrane);
  read_fluid(document, scene.fluid);
  read_flow(document, scene.flow);
  read_gravity(document, scene.gravity);
  read_accuracy(document, scene.accuracy);
  read_time(document, scene.time, scene.accuracy.preset);
  read_movie(document, scene.movie);
  read_output(document, folder, scene.output);
  return scene;
}

std::string text_of(const std::filesystem::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  if (stream)
  {
    text << stream.rdbuf();
  }
  if (!stream || std::filesystem::is_directory(file))
  {
    throw InputError(fmt::format("{}: can't be read: {}; allowed: a scene in TOML", file.string(),
      std::filesystem::exists(file) ? "not a readable file" : "no such file"));
  }
  return text.str();
}

/// A missing mesh is better said here, with the scene's line, than when it is read.
void check_mesh_exists(const SceneDocument& document, const Scene& scene)
{
  std::error_code ignored;
  if (scene.vesicle.mesh_file && !std::filesystem::exists(*scene.vesicle.mesh_file, ignored))
  {
    TableReader(document, "vesicle")
      .fail("file", fmt::format("there is no {}", scene.vesicle.mesh_file->string()),
        "the path of a mesh, relative to the scene's folder or absolute");
  }
}

}

Scene read_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
  const SceneDocument document = parse_document(text_of(file), file.string(), overrides);
  Scene scene = read_document(document, file.parent_path());
  check_mesh_exists(document, scene);
  scene.file = std::filesystem::absolute(file).lexically_normal();
  return scene;
}

Scene parse_scene(const std::string& text, const std::string& name,
  const std::filesystem::path& folder, const std::vector<std::string>& overrides)
{
  return read_document(parse_document(text, name, overrides), folder);
}

}
