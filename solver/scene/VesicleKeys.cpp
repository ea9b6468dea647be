// The keys of [vesicle]: a start shape's, or a mesh file's.

#include "solver/scene/SceneRules.h"
#include "solver/scene/SceneSchema.h"

#include <cmath>

namespace vesicle
{
namespace
{

using Kind = ShapeRequest::Kind;
using Vesicle = Scene::Vesicle;

constexpr NumberRule fraction{ [](double x) { return x > 0 && x <= 1; },
  "a number > 0 and <= 1 (1 is a sphere)" };
constexpr IntegerRule degree{ [](int l) { return l >= 0; }, "an integer >= 0" };
constexpr IntegerRule any_integer{ [](int) { return true; }, "an integer" };

const std::string from_file = "file";

std::vector<std::string> shape_words()
{
  std::vector<std::string> words;
  words.reserve(shape_kinds.size());
  for (const Kind kind : shape_kinds)
    words.push_back(shape_name(kind));
  return words;
}

struct ShapeWord
{
  void read(const TableReader& table, const std::string& key, Kind& target) const
  {
    std::string word;
    table.read(key, word, shape_words());
    target = shape_kind(word);
  }
  std::string write(Kind value) const { return to_toml(shape_name(value)); }
  std::string allowed() const { return in_quotes(shape_words()); }
};

/// An axis, brought to length 1, and an angle.
struct Rotation
{
  void read(const TableReader& table, const std::string& key,
    std::optional<std::array<double, 4>>& target) const
  {
    table.read(key, target, any_number);
    auto& rotation = *target;
    const Vector3 axis(rotation[0], rotation[1], rotation[2]);
    if (axis.isZero(0))
      table.fail(key, "its axis can't be the zero vector", allowed());
    const Vector3 unit = unit_direction(axis);
    rotation = { unit[0], unit[1], unit[2], rotation[3] };
  }
  std::string write(const std::optional<std::array<double, 4>>& value) const
  {
    return to_toml(value);
  }
  std::string allowed() const { return "[axis x, y, z, degrees], the axis not all 0"; }
};

/// Where one is given.
struct OptionalPoint
{
  void read(const TableReader& table, const std::string& key, std::optional<Vector3>& target) const
  {
    table.read(key, target);
  }
  std::string write(const std::optional<Vector3>& value) const { return to_toml(value); }
  std::string allowed() const { return rules::Point{}.allowed(); }
};

struct Modes
{
  void read(const TableReader& table, const std::string& key, std::vector<ShapeMode>& target) const
  {
    target.clear();
    for (const auto& item : table.items(key, table.at(key), 0, allowed()))
      target.push_back(mode(table, key, item));
    if (target.empty())
      table.fail(key, "can't be empty", allowed());
  }
  ShapeMode mode(const TableReader& table, const std::string& key, const SceneValue& item) const
  {
    const auto& values = table.items(key, item, 3, allowed());
    ShapeMode mode;
    mode.l = table.integer(key, values[0], degree);
    mode.m = table.integer(key, values[1], any_integer);
    mode.amplitude = table.number(key, values[2], any_number);
    if (std::abs(static_cast<double>(mode.m)) > mode.l)
      table.fail_at(
        item.where, key, fmt::format("can't have m = {} with l = {}", mode.m, mode.l), allowed());
    return mode;
  }
  std::string write(const std::vector<ShapeMode>& value) const { return to_toml(value); }
  std::string allowed() const
  {
    return "[[l, m, amplitude], …] with integers l >= 0 and |m| <= l, amplitude in units of the "
           "radius";
  }
};

SceneTable::Variant variant_in(const SceneTable& vesicle, const TableReader& table)
{
  if (table.has("file"))
  {
    if (table.has("shape"))
      table.fail(
        "file", "contradicts 'shape': the vesicle starts from one of them", "file or shape");
    return { from_file, "'file'" };
  }
  if (!table.has("shape"))
  {
    table.check_keys(vesicle.names());
    table.fail("shape", "is missing", ShapeWord{}.allowed() + ", or 'file' with a mesh");
  }
  std::string word;
  table.read("shape", word, shape_words());
  return { word, fmt::format("shape = \"{}\"", word) };
}

std::string variant_of(const Scene& scene)
{
  return scene.vesicle.mesh_file ? from_file : shape_name(scene.vesicle.shape.kind);
}

void make_example(Scene& scene, const std::string& variant)
{
  if (variant == from_file)
    scene.vesicle.mesh_file = "/mesh.vtu";
  else
    scene.vesicle.shape.kind = shape_kind(variant);
}

void check(const TableReader& table, const Scene& scene)
{
  const ShapeRequest& shape = scene.vesicle.shape;
  if (table.has("axis") && table.has("rotation"))
    table.fail(
      "rotation", "contradicts 'axis': a shape is turned by one of them", "rotation or axis");
  if (shape.kind == Kind::sphere && shape.reduced_volume.value_or(1) != 1)
    table.fail("reduced_volume", "does not go with shape = \"sphere\"", "1, or another shape");
}

const std::string triangles_help =
  "met exactly if a multiple of 10 or 12 (above 2,000 of 40 or 48)";

std::vector<SceneKey> vesicle_keys()
{
  const auto in_shape = [](auto member) { return at(&Scene::vesicle, &Vesicle::shape, member); };
  const auto shapes = shape_words();
  const std::string prolate = shape_name(Kind::prolate), oblate = shape_name(Kind::oblate),
                    ellipsoid = shape_name(Kind::ellipsoid),
                    perturbed = shape_name(Kind::perturbed),
                    stomatocyte = shape_name(Kind::stomatocyte);
  const std::vector<std::string> deflated{ shape_name(Kind::sphere), prolate, oblate, ellipsoid,
    shape_name(Kind::discocyte), stomatocyte };
  return {
    key("shape", in_shape(&ShapeRequest::kind), ShapeWord{}, "", "of the start")
      .with(shapes)
      .required(),
    key("file", at(&Scene::vesicle, &Vesicle::mesh_file), rules::Path{ "the path of a mesh" }, "",
      "start mesh, taken as it is where nothing else is said; instead of shape")
      .with({ from_file })
      .required(),
    key("merge", at(&Scene::vesicle, &Vesicle::mesh_merge), rules::Number{ positive }, "length",
      "points of the mesh nearer than this become one, so that seams close")
      .with({ from_file })
      .otherwise("as it is"),
    key("radius", at(&Scene::vesicle, &Vesicle::radius), rules::Number{ positive }, "length",
      "r0 = (3V/4π)^(1/3)")
      .with(shapes),
    key("radius", at(&Scene::vesicle, &Vesicle::mesh_radius), rules::Number{ positive }, "length",
      "r0 that the mesh is scaled to")
      .with({ from_file })
      .otherwise("as it is"),
    key("triangles", in_shape(&ShapeRequest::triangles), rules::Integer{ triangle_count }, "",
      triangles_help)
      .with(shapes),
    key("triangles", at(&Scene::vesicle, &Vesicle::mesh_triangles),
      rules::Integer{ triangle_count }, "", "number that the mesh is resampled to")
      .with({ from_file })
      .otherwise("as it is"),
    key("axis", at(&Scene::vesicle, &Vesicle::axis), rules::Direction{}, "",
      "symmetry or long axis; not together with rotation")
      .with(shapes)
      .written_if([](const Scene& scene) { return !scene.vesicle.rotation; }),
    key("rotation", at(&Scene::vesicle, &Vesicle::rotation), Rotation{}, "",
      "axis and angle of a turn about the centroid")
      .otherwise("not turned"),
    key("center", at(&Scene::vesicle, &Vesicle::center), rules::Point{}, "length",
      "centroid of the volume")
      .with(shapes),
    key("center", at(&Scene::vesicle, &Vesicle::mesh_center), OptionalPoint{}, "length",
      "where the mesh's centroid of the volume is moved to")
      .with({ from_file })
      .otherwise("where it is"),
    key("semi_axes", in_shape(&ShapeRequest::semi_axes), rules::Number{ positive, "[a, b, c]" }, "",
      "along x, y, z, to be scaled to the radius; with a reduced volume first raised to a common "
      "power until it holds")
      .with({ ellipsoid })
      .required(),
    key("reduced_volume", in_shape(&ShapeRequest::reduced_volume), rules::Number{ fraction }, "",
      "6 √π V / A^(3/2); of a sphere: 1")
      .with(deflated)
      .required("", { prolate, oblate, stomatocyte })
      .otherwise("the shape's own"),
    key("modes", in_shape(&ShapeRequest::modes), Modes{}, "",
      "r = radius (1 + Σ amplitude Y_lm), real and orthonormal Y_lm")
      .with({ perturbed })
      .required(),
  };
}

}

SceneTable vesicle_table()
{
  SceneTable table;
  table.name = "vesicle";
  table.help =
    "The start: a shape, or a mesh from a file. Of several vesicles each has a table "
    "`[[vesicle]]`. "
    "Tables\n`[vesicle.membrane]`, `[vesicle.fluid]` (but for the viscosity outside) and "
    "`[vesicle.gravity]` after it stand in place of the\nscene's for that vesicle. They are "
    "numbered "
    "from 0: `--set vesicle.1.triangles=320`, `--set vesicle.triangles=320` for all.";
  table.keys = vesicle_keys();
  table.variants = {
    { shape_name(Kind::sphere), "a sphere" },
    { shape_name(Kind::prolate), "ellipsoid of revolution, long along the axis" },
    { shape_name(Kind::oblate), "ellipsoid of revolution, short along the axis" },
    { shape_name(Kind::ellipsoid), "ellipsoid" },
    { shape_name(Kind::discocyte), "the red blood cell's biconcave disc" },
    { shape_name(Kind::perturbed), "sphere with spherical harmonics added" },
    { shape_name(Kind::stomatocyte), "a bowl with a narrow mouth, which opens along the axis" },
    { from_file, "a mesh" },
  };
  table.variant_in = variant_in;
  table.variant_of = variant_of;
  table.make_example = make_example;
  table.check = check;
  return table;
}

}
