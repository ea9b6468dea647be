#include "solver/scene/SceneSchema.h"

#include "solver/scene/SceneRules.h"

#include <algorithm>

namespace vesicle
{
namespace
{

constexpr NumberRule tree_tolerances{ [](double x) { return x >= 1e-12 && x <= 1e-3; },
  "a number from 1e-12 to 1e-3" };
constexpr NumberRule below_one{ [](double x) { return x > 0 && x < 1; }, "a number > 0 and < 1" };
constexpr IntegerRule quadrature_points{
  [](int n) { return n == 1 || n == 3 || n == 6 || n == 12; }, "1, 3, 6, 12"
};
constexpr IntegerRule marker_count{ [](int n) { return n >= 0 && n <= 1000; },
  "an integer from 0 to 1000" };
constexpr IntegerRule pixels{ [](int n) { return n >= 16 && n <= 16384; },
  "an integer from 16 to 16384" };

bool usable_in_file_names(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
    c == '.' || c == '-';
}

/// A name that becomes that of folders and files.
struct FileName
{
  void read(const TableReader& table, const std::string& key, std::string& target) const
  {
    table.read(key, target);
    const bool usable = !target.empty() && target != "." && target != ".." &&
      std::all_of(target.begin(), target.end(), usable_in_file_names);
    if (!usable)
      table.fail(key, fmt::format("\"{}\" can't be used as a file name", target), allowed());
  }
  std::string write(const std::string& value) const { return to_toml(value); }
  std::string allowed() const { return "letters, digits, '_', '.', '-'"; }
};

/// A scene that gives no name has its file's, without the ending.
void default_name(const SceneDocument& document, Scene& scene)
{
  if (document.find("", "name"))
    return;
  std::string name = std::filesystem::path(document.name).stem().string();
  std::replace_if(
    name.begin(), name.end(), [](char c) { return !usable_in_file_names(c); }, '-');
  scene.name = name.empty() || name == "." || name == ".." ? "vesicle" : name;
}

/// Two numbers, the first below the second.
struct Interval
{
  void read(const TableReader& table, const std::string& key,
    std::optional<std::array<double, 2>>& target) const
  {
    table.read(key, target, any_number);
    if (!((*target)[0] < (*target)[1]))
      table.fail(key, "its first number must be below its second", allowed());
  }
  std::string write(const std::optional<std::array<double, 2>>& value) const
  {
    return to_toml(value);
  }
  std::string allowed() const { return "[a, b] with a < b"; }
};

struct PictureSize
{
  void read(const TableReader& table, const std::string& key, std::array<int, 2>& target) const
  {
    const auto& size = table.items(key, table.at(key), 2, allowed());
    target = { table.integer(key, size[0], pixels), table.integer(key, size[1], pixels) };
  }
  std::string write(const std::array<int, 2>& value) const { return to_toml(value); }
  std::string allowed() const { return fmt::format("[width, height], each {}", pixels.allowed); }
};

/// A time, or a state to end in.
struct End
{
  static constexpr const char* steady = "steady";
  static constexpr const char* equilibrium = "equilibrium";

  void read(const TableReader& table, const std::string& key, Scene::Time& target) const
  {
    const SceneValue& value = table.at(key);
    const auto* text = std::get_if<std::string>(&value.data);
    if (text && *text != steady && *text != equilibrium)
      table.fail(key, "can't be " + value.description(), allowed());
    target.equilibrium = text && *text == equilibrium;
    const std::string all = allowed();
    if (text)
      target.end.reset();
    else
      target.end = table.number(key, value, { positive.holds, all.c_str() });
  }
  std::string write(const Scene::Time& time) const
  {
    return time.end ? to_toml(*time.end)
                    : to_toml(std::string(time.equilibrium ? equilibrium : steady));
  }
  std::string allowed() const
  {
    return fmt::format("{}, \"{}\" or \"{}\"", positive.allowed, steady, equilibrium);
  }
};

/// What must be given for a run needn't for an equilibrium.
SceneTable::Variant time_variant(const SceneTable&, const TableReader& table)
{
  const auto* text = table.has("end") ? std::get_if<std::string>(&table.at("end").data) : nullptr;
  if (text && *text == End::equilibrium)
    return { "equilibrium", "end = \"equilibrium\"" };
  return { "run", "" };
}

SceneTable top_table()
{
  SceneTable table;
  table.help = "At the top, before the tables:";
  table.keys = {
    key("name", at(&Scene::name), FileName{}, "", "of the folder and the files of a run")
      .otherwise("the scene's file's, without the ending")
      .followed_by(default_name),
    key("units", at(&Scene::units), rules::Choice{ units_names }, "",
      "of the numbers below; \"any\": one system of your choice; values may also have units each, "
      "\"10 um\", \"20 kT\", and are SI then")
      .written_if([](const Scene& scene) { return scene.units != Units::any; }),
  };
  return table;
}

/// A word, or the path of a mesh.
struct ReferenceShape
{
  using Reference = Scene::Membrane::Reference;
  static constexpr const char *start = "start", *sphere = "sphere";

  void read(const TableReader& table, const std::string& key, Scene::Membrane& target) const
  {
    std::string text;
    table.read(key, text);
    target.reference_file.reset();
    target.reference = text == start ? Reference::start
      : text == sphere               ? Reference::sphere
                                     : Reference::file;
    if (target.reference == Reference::file)
      rules::Path{ "\"start\", \"sphere\" or the path of a mesh" }.read(
        table, key, target.reference_file);
  }
  std::string write(const Scene::Membrane& membrane) const
  {
    if (membrane.reference == Reference::file)
      return rules::Path{ "" }.write(membrane.reference_file);
    return to_toml(std::string(membrane.reference == Reference::sphere ? sphere : start));
  }
  std::string allowed() const { return "\"start\", \"sphere\" or the path of a mesh"; }
};

bool is_elastic(const Scene& scene)
{
  return scene.membrane.shear_modulus.has_value();
}

SceneTable membrane_table()
{
  using Membrane = Scene::Membrane;
  const NumberRule rigidity{ positive.holds, "a number > 0; leave the key out for no bending" };
  SceneTable table;
  table.name = "membrane";
  table.help = "What the membrane resists.";
  table.keys = {
    key("bending_rigidity", at(&Scene::membrane, &Membrane::bending_rigidity),
      rules::Number{ rigidity }, "energy", "EB of the energy E = (EB/2) ∮ (2H − c0)² dS")
      .otherwise("no bending"),
    key("spontaneous_curvature", at(&Scene::membrane, &Membrane::spontaneous_curvature),
      rules::Number{ any_number }, "1/length",
      "c0, the 2H that bending prefers; needs bending_rigidity")
      .written_if([](const Scene& scene) { return scene.membrane.bending_rigidity.has_value(); }),
    key("area_difference_stiffness", at(&Scene::membrane, &Membrane::area_difference_stiffness),
      rules::Number{ positive }, "bending_rigidity",
      "α of the energy 8π² α EB (m − m0)², m = ∮ H dS/√(4πA); needs bending_rigidity")
      .otherwise("leaflets exchange area freely"),
    key("area_difference", at(&Scene::membrane, &Membrane::area_difference),
      rules::Number{ any_number }, "",
      "m0, the m that the leaflets' areas prefer, a sphere's is 1; needs area_difference_stiffness")
      .written_if(
        [](const Scene& scene) { return scene.membrane.area_difference_stiffness.has_value(); }),
    key("incompressible", at(&Scene::membrane, &Membrane::incompressible), rules::Flag{}, "",
      "a tension keeps the area of every patch; false: no tension"),
    key("shear_modulus", at(&Scene::membrane, &Membrane::shear_modulus), rules::Number{ positive },
      "energy/area", "G of an elastic sheet; needs mesh_motion = \"material\"")
      .otherwise("a fluid"),
    key("elasticity", at(&Scene::membrane, &Membrane::elasticity),
      rules::Choice{ elasticity_names }, "",
      "\"neo-hookean\": (G/2) (I1 − 1 + 1/(I2 + 1)) an area; \"skalak\": (G/4) (I1² + 2 I1 − 2 I2 "
      "+ C I2²); needs shear_modulus")
      .written_if(is_elastic),
    key("dilation_modulus", at(&Scene::membrane, &Membrane::dilation_modulus),
      rules::Number{ positive }, "shear_modulus", "C of Skalak's law; needs shear_modulus")
      .written_if(is_elastic),
    key("reference", at(&Scene::membrane), ReferenceShape{}, "",
      "the shape without stress: \"start\", the start's; \"sphere\", a sphere on which every patch "
      "of "
      "the start has its area; or a mesh with the start's points and triangles in their order; "
      "needs "
      "shear_modulus")
      .written_if(is_elastic),
    key("prestretch", at(&Scene::membrane, &Membrane::prestretch), rules::Number{ positive }, "",
      "lengths of the start over those without stress, beside what the reference differs by; needs "
      "shear_modulus")
      .written_if(is_elastic),
    key("surface_viscosity", at(&Scene::membrane, &Membrane::surface_viscosity),
      rules::Number{ not_negative }, "pressure × time × length",
      "η of the membrane's resistance to shear within itself; other than 0 on Loop's surface only"),
  };
  table.check = [](const TableReader& reader, const Scene& scene)
  {
    if (!scene.membrane.bending_rigidity && reader.has("spontaneous_curvature"))
      reader.fail("spontaneous_curvature", "does nothing without bending",
        "a number, beside bending_rigidity");
    if (!scene.membrane.bending_rigidity && reader.has("area_difference_stiffness"))
      reader.fail("area_difference_stiffness",
        "is counted in the bending rigidity, which isn't there",
        "a number > 0, beside bending_rigidity");
    if (!scene.membrane.area_difference_stiffness && reader.has("area_difference"))
      reader.fail("area_difference", "does nothing without area_difference_stiffness",
        "a number, beside area_difference_stiffness");
    for (const char* key : { "elasticity", "dilation_modulus", "reference", "prestretch" })
      if (!scene.membrane.shear_modulus && reader.has(key))
        reader.fail(key, "does nothing without shear_modulus", "it beside shear_modulus");
  };
  return table;
}

SceneTable fluid_table()
{
  SceneTable table;
  table.name = "fluid";
  table.help = "The fluids outside and inside.";
  table.keys = {
    key("viscosity", at(&Scene::fluid, &Scene::Fluid::viscosity), rules::Number{ positive },
      "pressure × time", "μ of the fluid outside"),
    key("viscosity_ratio", at(&Scene::fluid, &Scene::Fluid::viscosity_ratio),
      rules::Number{ not_negative }, "",
      "λ, of the fluid inside to that outside; other than 1 on Loop's surface only"),
    key("temperature", at(&Scene::fluid, &Scene::Fluid::temperature), rules::Number{ positive },
      "temperature", "of which kT is made, where values have units")
      .written_if([](const Scene& scene) { return scene.units == Units::si; }),
  };
  table.check = [](const TableReader& reader, const Scene& scene)
  {
    if (scene.units == Units::any && reader.has("temperature"))
      reader.fail("temperature", "does nothing where values have no units",
        "it beside values with units, \"20 kT\"");
  };
  return table;
}

SceneTable wall_table()
{
  const auto in_wall = [](auto member)
  {
    return [=](auto& scene) -> auto&
    {
      return (*scene.wall).*member;
    };
  };
  SceneTable table;
  table.name = "wall";
  table.help =
    "A plane at which the fluid sticks, beside all vesicles, where the flow is zero; on Loop's "
    "surface only. Without the table the fluid has no end.";
  table.keys = {
    key("point", in_wall(&Wall::point), rules::Point{}, "length", "any of the plane"),
    key("normal", in_wall(&Wall::normal), rules::Direction{}, "", "into the fluid"),
  };
  table.present = [](const Scene& scene) { return scene.wall.has_value(); };
  table.create = [](Scene& scene) { scene.wall = Wall{}; };
  return table;
}

/// Either a Bond number or both of the others.
SceneTable::Variant gravity_variant(const SceneTable&, const TableReader& table)
{
  const bool by_density = table.has("density_difference") || table.has("acceleration");
  if (table.has("bond_number") && by_density)
    table.fail("bond_number", "contradicts 'density_difference' and 'acceleration'",
      "bond_number, or both density_difference and acceleration");
  return { by_density ? "density" : "bond", "" };
}

SceneTable gravity_table()
{
  const auto in_gravity = [](auto member)
  {
    return [=](auto& scene) -> auto&
    {
      return (*scene.gravity).*member;
    };
  };
  const auto by_density = [](const Scene& scene) { return !scene.gravity->bond_number; };
  const std::string either = "bond_number, or both density_difference and acceleration";
  using Gravity = Scene::Gravity;
  SceneTable table;
  table.name = "gravity";
  table.help = "The load Δρ g z n on the membrane: bond_number, or both of the others. Without the "
               "table there is none.";
  table.keys = {
    key("bond_number", in_gravity(&Gravity::bond_number), rules::Number{}, "",
      "Bo = Δρ g r0⁴/EB; above 0 the vesicle rises along +z")
      .required(either, { "bond" }),
    key("density_difference", in_gravity(&Gravity::density_difference), rules::Number{},
      "mass / volume", "Δρ, outside less inside; above 0 the vesicle rises")
      .required(either, { "density" })
      .written_if(by_density),
    key("acceleration", in_gravity(&Gravity::acceleration), rules::Number{}, "length / time²",
      "g, along −z")
      .required(either, { "density" })
      .written_if(by_density),
  };
  table.variant_in = gravity_variant;
  table.present = [](const Scene& scene) { return scene.gravity.has_value(); };
  table.create = [](Scene& scene) { scene.gravity = Scene::Gravity{}; };
  return table;
}

SceneTable interaction_table()
{
  const auto in_interaction = [](auto member)
  {
    return [=](auto& scene) -> auto&
    {
      return (*scene.interaction).*member;
    };
  };
  using Interaction = Scene::Interaction;
  SceneTable table;
  table.name = "interaction";
  table.help =
    "A short-range repulsion between vesicles, ∮ repulsion (range/d − 1)² dS over each where its "
    "distance d to another is below the range. Without the table there is none.";
  table.keys = {
    key("repulsion", in_interaction(&Interaction::repulsion), rules::Number{ positive },
      "energy / area", "its strength")
      .required(),
    key("range", in_interaction(&Interaction::range), rules::Number{ positive }, "length",
      "where it begins")
      .required(),
  };
  table.present = [](const Scene& scene) { return scene.interaction.has_value(); };
  table.create = [](Scene& scene) { scene.interaction = Interaction{}; };
  return table;
}

SceneTable time_table()
{
  using Time = Scene::Time;
  SceneTable table;
  table.name = "time";
  table.help = "How long, how often, how exactly.";
  SceneKey output_every =
    key("output_every", at(&Scene::time, &Time::output_every), rules::Number{ positive }, "time",
      "what lies between two frames; its multiples are hit exactly")
      .required("", { "run" })
      .otherwise("required but for an equilibrium");
  // In memory 0 stands for "only start and end", which a file says with the end itself.
  output_every.write = [](const Scene& scene)
  {
    const Time& time = scene.time;
    return to_toml(time.output_every == 0 && time.end ? *time.end : time.output_every);
  };
  table.variant_in = time_variant;
  table.keys = {
    key("end", at(&Scene::time), End{}, "time",
      "of the run; \"steady\": when the shape's points move across it by less than 2e-3 r0 in the "
      "run's unit of time; \"equilibrium\": no run, the shape at rest by `vesicle equilibrium`, "
      "without flow and gravity")
      .required(),
    output_every,
    key("step", at(&Scene::time, &Time::step), rules::NumberOr{ "auto", positive }, "time",
      "of every step; \"auto\": as the tolerance allows"),
    key("tolerance", at(&Scene::time, &Time::tolerance), rules::Number{ positive }, "r0",
      "error of a position in a step, with step = \"auto\"; 1e-4 with the preset \"accurate\""),
  };
  table.check = [](const TableReader& reader, const Scene& scene)
  {
    if (!scene.time.end && !scene.time.equilibrium && scene.flow_history.recurs())
      reader.fail("end", "never comes: the flow varies for ever", "a time");
  };
  return table;
}

/// What a preset stands for, unless the scene says otherwise.
void apply_preset(const SceneDocument& document, Scene& scene)
{
  const Scene::Preset preset = scene.accuracy.preset;
  scene.accuracy = Scene::preset(preset);
  if (!document.find("time", "tolerance"))
    scene.time.tolerance = Scene::preset_tolerance(preset);
}

void check_adaptive(const TableReader& table, const Scene::Accuracy& accuracy)
{
  const bool adaptive = accuracy.mesh_motion == Scene::MeshMotion::adaptive;
  const bool by_sums = accuracy.layer == LayerMethod::direct || accuracy.layer == LayerMethod::tree;
  if (by_sums && accuracy.basis != Scene::Basis::loop)
    table.fail("operator", "applies the layer of Loop's surface only", "basis = \"loop\"");
  if (adaptive && accuracy.basis != Scene::Basis::loop)
    table.fail("mesh_motion", "lays meshes anew on Loop's surface only", "basis = \"loop\"");
  for (const char* key : { "least_triangles", "most_triangles" })
    if (!adaptive && table.has(key))
      table.fail(key, "goes with meshes that are laid anew", "mesh_motion = \"adaptive\"");
  if (accuracy.least_triangles && accuracy.most_triangles &&
    *accuracy.least_triangles > *accuracy.most_triangles)
    table.fail("most_triangles", "are fewer than least_triangles",
      fmt::format("an integer >= {}", *accuracy.least_triangles));
}

void check_accuracy(const TableReader& table, const Scene& scene)
{
  const Scene::Accuracy& accuracy = scene.accuracy;
  if (accuracy.scheme == Scene::Scheme::paper && accuracy.basis != Scene::Basis::linear)
    table.fail("basis", "the paper's scheme is one of linear elements", "\"linear\"");
  if (accuracy.bending != Scene::bending_of(accuracy.basis))
    table.fail("bending", "doesn't go with the basis",
      "\"cotan\" with basis \"linear\", \"variational\" with \"loop\"");
  if (scene.fluid.viscosity_ratio != 1 && accuracy.basis != Scene::Basis::loop)
    table.fail(table.has("basis") ? "basis" : "preset",
      "has fluids of one viscosity only, and fluid.viscosity_ratio isn't 1",
      "\"balanced\" or \"accurate\", or basis = \"loop\"");
  if (scene.wall && accuracy.basis != Scene::Basis::loop)
    table.fail(table.has("basis") ? "basis" : "preset",
      "knows no walls, and the scene has a [wall]",
      "\"balanced\" or \"accurate\", or basis = \"loop\"");
  if (scene.membrane.surface_viscosity != 0 && accuracy.basis != Scene::Basis::loop)
    table.fail(table.has("basis") ? "basis" : "preset",
      "has no viscosity of the membrane, and membrane.surface_viscosity isn't 0",
      "\"balanced\" or \"accurate\", or basis = \"loop\"");
  if (is_elastic(scene) &&
    (accuracy.basis != Scene::Basis::loop || accuracy.mesh_motion != Scene::MeshMotion::material))
    table.fail("mesh_motion", "loses the material of an elastic membrane (membrane.shear_modulus)",
      "\"material\", on Loop's surface");
  check_adaptive(table, accuracy);
}

SceneTable accuracy_table()
{
  using Accuracy = Scene::Accuracy;
  SceneTable table;
  table.name = "accuracy";
  table.help = "How surface, forces and time are discretised: a preset, and changes to it.";
  table.keys = {
    key("preset", at(&Scene::accuracy, &Accuracy::preset), rules::Choice{ preset_names }, "",
      "\"paper\": flat elements, forces as the paper prints them (misprints corrected); \"fast\": "
      "flat elements, forces in weak form; \"balanced\": Loop's limit surface; \"accurate\": the "
      "same with a finer quadrature and a tighter tolerance")
      .followed_by(apply_preset),
    key("basis", at(&Scene::accuracy, &Accuracy::basis), rules::Choice{ basis_names }, "",
      "of the surface: flat triangles or Loop's limit surface; \"linear\" with the presets "
      "\"paper\" and \"fast\"")
      .followed_by([](const SceneDocument&, Scene& scene)
        { scene.accuracy.bending = Scene::bending_of(scene.accuracy.basis); }),
    key("bending", at(&Scene::accuracy, &Accuracy::bending), rules::Choice{ bending_names }, "",
      "scheme of the bending force: the basis decides, \"cotan\" goes with \"linear\", "
      "\"variational\" with \"loop\"; the other one is refused"),
    key("integrator", at(&Scene::accuracy, &Accuracy::integrator),
      rules::Choice{ integrator_names }, "",
      "of second or first order in time; \"imex-euler\" with the preset \"paper\""),
    key("mesh_motion", at(&Scene::accuracy, &Accuracy::mesh_motion),
      rules::Choice{ mesh_motion_names }, "",
      "whether vertices spread by the membrane's curvature or move with its lipids; \"adaptive\": "
      "they spread, and the mesh is laid anew where it no longer holds the shape; \"material\" "
      "with the preset \"paper\""),
    key("least_triangles", at(&Scene::accuracy, &Accuracy::least_triangles),
      rules::Integer{ triangle_count }, "", "of meshes that are laid anew; with \"adaptive\"")
      .otherwise("those of the start mesh"),
    key("most_triangles", at(&Scene::accuracy, &Accuracy::most_triangles),
      rules::Integer{ triangle_count }, "", "of meshes that are laid anew; with \"adaptive\"")
      .otherwise("four times those of the start mesh"),
    key("quadrature", at(&Scene::accuracy, &Accuracy::quadrature),
      rules::Integer{ quadrature_points }, "",
      "points a triangle of the regular rule; 6 with the preset \"accurate\""),
    key("operator", at(&Scene::accuracy, &Accuracy::layer), rules::Choice{ layer_method_names }, "",
      "how the single layer of Loop's surface is applied: by sums over all pairs of points and "
      "vertices (\"direct\"), over pairs of clusters of them (\"tree\", which \"auto\" takes where "
      "there are many) or by its matrix; on flat triangles it is a matrix"),
    key("precision", at(&Scene::accuracy, &Accuracy::precision),
      rules::Choice{ layer_precision_names }, "",
      "of far fields in the linear solves on Loop's surface; \"mixed\": single where that doesn't "
      "change the answer"),
    key("tree_tolerance", at(&Scene::accuracy, &Accuracy::tree_tolerance),
      rules::Number{ tree_tolerances }, "",
      "relative error of the velocity that clusters leave, where the operator has them"),
    key("linear_tolerance", at(&Scene::accuracy, &Accuracy::linear_tolerance),
      rules::Number{ below_one }, "",
      "relative error of the velocity that the linear solves leave; 1e-8 with the preset "
      "\"accurate\", "
      "1e-10 with \"fast\" and \"paper\""),
  };
  table.check = check_accuracy;
  return table;
}

SceneTable movie_table()
{
  using Movie = Scene::Movie;
  SceneTable table;
  table.name = "movie";
  table.help = "The pictures of a run.";
  table.keys = {
    key("color", at(&Scene::movie, &Movie::color), rules::Word{ field_names }, "",
      "point array that colours the membrane, vectors by magnitude"),
    key("range", at(&Scene::movie, &Movie::range), Interval{}, "that of the array",
      "ends of the colours")
      .otherwise("the whole movie's but for outliers"),
    key("size", at(&Scene::movie, &Movie::size), PictureSize{}, "pixels", "of a picture"),
    key("view", at(&Scene::movie, &Movie::view), rules::Word{ view_names }, "",
      "\"front\": x to the right, z up"),
    key("camera", at(&Scene::movie, &Movie::camera), rules::Word{ camera_names }, "",
      "whether it follows the centroid"),
    key("smooth", at(&Scene::movie, &Movie::smooth), rules::Flag{}, "",
      "the Loop surface through the points, for display"),
    key("arrows", at(&Scene::movie, &Movie::arrows), rules::Flag{}, "",
      "the flow of lipids along the membrane"),
    key("flow_lines", at(&Scene::movie, &Movie::flow_lines), rules::Flag{}, "",
      "the flow of the fluid, in the plane through the middle"),
    key("markers", at(&Scene::movie, &Movie::markers), rules::Integer{ marker_count }, "",
      "dots on each vesicle that the membrane carries along"),
    key("edges", at(&Scene::movie, &Movie::edges), rules::Flag{}, "", "the mesh"),
    key("chart", at(&Scene::movie, &Movie::chart), rules::Word{ chart_names }, "",
      "a quantity against time, at the side"),
  };
  return table;
}

SceneTable output_table()
{
  using Output = Scene::Output;
  SceneTable table;
  table.name = "output";
  table.help = "What a run leaves behind.";
  table.keys = {
    key("fields", at(&Scene::output, &Output::fields), rules::Words{ field_names }, "",
      "point arrays of the frames; empty: all that there are"),
    key("directory", at(&Scene::output, &Output::directory), rules::Path{ "the path of a folder" },
      "", "where to")
      .otherwise("./<name>"),
  };
  return table;
}

}

const std::vector<SceneTable>& scene_schema()
{
  static const std::vector<SceneTable> tables{ top_table(), vesicle_table(), membrane_table(),
    fluid_table(), flow_table(), wall_table(), gravity_table(), interaction_table(), time_table(),
    accuracy_table(), movie_table(), output_table() };
  return tables;
}

const SceneKey& scene_key(const std::string& table, const std::string& name)
{
  const auto& tables = scene_schema();
  const auto& keys = std::find_if(tables.begin(), tables.end(),
    [&](const SceneTable& candidate) {
      return candidate.name == table;
    })->keys;
  return *std::find_if(
    keys.begin(), keys.end(), [&](const SceneKey& candidate) { return candidate.name == name; });
}

}
