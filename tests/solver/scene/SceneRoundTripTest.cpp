// What the reader makes of right scenes, and that the writer's text gives the same scene again.

#include "solver/flow/Extension.h"
#include "solver/flow/Poiseuille.h"
#include "solver/flow/Shear.h"
#include "solver/flow/Uniform.h"
#include "solver/scene/SceneFile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <random>

using namespace vesicle;

namespace
{

const std::filesystem::path scenes_folder =
  std::filesystem::path(VESICLE_SOURCE_DIR) / "data/scenes";

/// Every member of two scenes, bit for bit.
void expect_same(const Scene& a, const Scene& b)
{
  EXPECT_EQ(a.name, b.name);

  const auto &va = a.vesicle, &vb = b.vesicle;
  EXPECT_EQ(va.shape.kind, vb.shape.kind);
  EXPECT_EQ(va.shape.triangles, vb.shape.triangles);
  EXPECT_EQ(va.shape.reduced_volume, vb.shape.reduced_volume);
  EXPECT_EQ(va.shape.semi_axes, vb.shape.semi_axes);
  ASSERT_EQ(va.shape.modes.size(), vb.shape.modes.size());
  for (std::size_t i = 0; i < va.shape.modes.size(); ++i)
  {
    EXPECT_EQ(va.shape.modes[i].l, vb.shape.modes[i].l);
    EXPECT_EQ(va.shape.modes[i].m, vb.shape.modes[i].m);
    EXPECT_EQ(va.shape.modes[i].amplitude, vb.shape.modes[i].amplitude);
  }
  EXPECT_EQ(va.mesh_file, vb.mesh_file);
  EXPECT_EQ(va.mesh_merge, vb.mesh_merge);
  EXPECT_EQ(va.mesh_radius, vb.mesh_radius);
  EXPECT_EQ(va.mesh_triangles, vb.mesh_triangles);
  EXPECT_EQ(va.radius, vb.radius);
  EXPECT_EQ(va.axis, vb.axis);
  EXPECT_EQ(va.rotation, vb.rotation);
  EXPECT_EQ(va.center, vb.center);

  EXPECT_EQ(a.membrane.bending_rigidity, b.membrane.bending_rigidity);
  EXPECT_EQ(a.membrane.spontaneous_curvature, b.membrane.spontaneous_curvature);
  EXPECT_EQ(a.membrane.area_difference_stiffness, b.membrane.area_difference_stiffness);
  EXPECT_EQ(a.membrane.area_difference, b.membrane.area_difference);
  EXPECT_EQ(a.membrane.incompressible, b.membrane.incompressible);
  EXPECT_EQ(a.membrane.shear_modulus, b.membrane.shear_modulus);
  EXPECT_EQ(a.membrane.elasticity, b.membrane.elasticity);
  EXPECT_EQ(a.membrane.dilation_modulus, b.membrane.dilation_modulus);
  EXPECT_EQ(a.membrane.reference, b.membrane.reference);
  EXPECT_EQ(a.membrane.reference_file, b.membrane.reference_file);
  EXPECT_EQ(a.membrane.prestretch, b.membrane.prestretch);
  EXPECT_EQ(a.membrane.surface_viscosity, b.membrane.surface_viscosity);
  EXPECT_EQ(a.fluid.viscosity, b.fluid.viscosity);
  EXPECT_EQ(a.fluid.viscosity_ratio, b.fluid.viscosity_ratio);

  ASSERT_EQ(a.flow != nullptr, b.flow != nullptr);
  if (a.flow)
  {
    ASSERT_EQ(&a.flow->kind(), &b.flow->kind());
    for (const FlowParameter& parameter : a.flow->kind().parameters)
      std::visit(
        [&](auto member) { EXPECT_EQ((*a.flow).*member, (*b.flow).*member); }, parameter.member);
  }
  ASSERT_EQ(a.gravity.has_value(), b.gravity.has_value());
  if (a.gravity)
  {
    EXPECT_EQ(a.gravity->bond_number, b.gravity->bond_number);
    EXPECT_EQ(a.gravity->density_difference, b.gravity->density_difference);
    EXPECT_EQ(a.gravity->acceleration, b.gravity->acceleration);
  }
  ASSERT_EQ(a.wall.has_value(), b.wall.has_value());
  if (a.wall)
  {
    EXPECT_EQ(a.wall->point, b.wall->point);
    EXPECT_EQ(a.wall->normal, b.wall->normal);
  }
  EXPECT_EQ(a.time.end, b.time.end);
  EXPECT_EQ(a.time.output_every, b.time.output_every);
  EXPECT_EQ(a.time.step, b.time.step);
  EXPECT_EQ(a.time.tolerance, b.time.tolerance);

  EXPECT_EQ(a.accuracy.preset, b.accuracy.preset);
  EXPECT_EQ(a.accuracy.scheme, b.accuracy.scheme);
  EXPECT_EQ(a.accuracy.basis, b.accuracy.basis);
  EXPECT_EQ(a.accuracy.bending, b.accuracy.bending);
  EXPECT_EQ(a.accuracy.integrator, b.accuracy.integrator);
  EXPECT_EQ(a.accuracy.mesh_motion, b.accuracy.mesh_motion);
  EXPECT_EQ(a.accuracy.quadrature, b.accuracy.quadrature);
  EXPECT_EQ(a.accuracy.layer, b.accuracy.layer);
  EXPECT_EQ(a.accuracy.precision, b.accuracy.precision);
  EXPECT_EQ(a.accuracy.tree_tolerance, b.accuracy.tree_tolerance);
  EXPECT_EQ(a.accuracy.linear_tolerance, b.accuracy.linear_tolerance);

  EXPECT_EQ(a.movie.color, b.movie.color);
  EXPECT_EQ(a.movie.range, b.movie.range);
  EXPECT_EQ(a.movie.size, b.movie.size);
  EXPECT_EQ(a.movie.view, b.movie.view);
  EXPECT_EQ(a.movie.arrows, b.movie.arrows);
  EXPECT_EQ(a.movie.flow_lines, b.movie.flow_lines);
  EXPECT_EQ(a.movie.markers, b.movie.markers);
  EXPECT_EQ(a.movie.edges, b.movie.edges);
  EXPECT_EQ(a.movie.camera, b.movie.camera);
  EXPECT_EQ(a.movie.smooth, b.movie.smooth);
  EXPECT_EQ(a.movie.chart, b.movie.chart);
  EXPECT_EQ(a.output.fields, b.output.fields);
  EXPECT_EQ(a.output.directory, b.output.directory);

  ASSERT_EQ(a.companions.size(), b.companions.size());
  for (std::size_t v = 1; v < a.vesicles(); ++v)
    EXPECT_EQ(write_scene(a.alone(v)), write_scene(b.alone(v)));
}

Scene written_and_read(const Scene& scene)
{
  return parse_scene(write_scene(scene), "written.toml", "/elsewhere");
}

Scene parsed(const std::string& text)
{
  return parse_scene(text + "\n[time]\nend = 1\noutput_every = 2\n", "some scene.toml", "/scenes");
}

}

TEST(SceneRoundTrip, EveryExampleScene)
{
  int scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(scenes_folder))
  {
    SCOPED_TRACE(entry.path().string());
    const Scene scene = read_scene(entry.path());
    expect_same(scene, written_and_read(scene));
    EXPECT_EQ(scene.name, entry.path().stem());
    EXPECT_EQ(scene.file, entry.path());
    ++scenes;
  }
  EXPECT_GE(scenes, 7);
}

// Remarks are comments: the settings are the same.
TEST(SceneRoundTrip, WithRemarksToo)
{
  for (const auto& entry : std::filesystem::directory_iterator(scenes_folder))
  {
    SCOPED_TRACE(entry.path().string());
    const std::vector<std::string> overrides{ "time.tolerance=0.01" };
    const std::string text = annotated_scene(entry.path(), overrides);
    expect_same(read_scene(entry.path(), overrides), parse_scene(text, "annotated"));
    EXPECT_NE(text.find("by default"), std::string::npos);
  }
}

TEST(SceneRoundTrip, WithoutWhatThePresetStandsForToo)
{
  for (const auto& entry : std::filesystem::directory_iterator(scenes_folder))
  {
    SCOPED_TRACE(entry.path().string());
    const Scene scene = read_scene(entry.path());
    expect_same(scene, parse_scene(write_editable_scene(scene), "written.toml", "/elsewhere"));
  }
}

TEST(SceneRoundTrip, AnEditableScenesPresetCanBeReplaced)
{
  const std::string start = "[vesicle]\nshape = \"sphere\"\n[accuracy]\nprecision = \"double\"\n";
  const std::string text = write_editable_scene(parsed(start));
  const auto accuracy = parse_scene(text, "t", ".", { "accuracy.preset=accurate" }).accuracy;
  EXPECT_EQ(accuracy.quadrature, Scene::preset(Scene::Preset::accurate).quadrature);
  EXPECT_EQ(accuracy.precision, LayerPrecision::full); // was asked for
}

TEST(SceneRoundTrip, Defaults)
{
  const Scene scene = parsed("[vesicle]\nshape = \"sphere\"");
  EXPECT_EQ(scene.name, "some-scene");
  EXPECT_EQ(scene.vesicle.shape.triangles, 1280);
  EXPECT_EQ(scene.vesicle.radius, 1);
  EXPECT_EQ(scene.vesicle.axis, Vector3(0, 0, 1));
  EXPECT_FALSE(scene.membrane.bending_rigidity);
  EXPECT_TRUE(scene.membrane.incompressible);
  EXPECT_EQ(scene.fluid.viscosity, 1);
  EXPECT_FALSE(scene.flow);
  EXPECT_FALSE(scene.gravity);
  EXPECT_FALSE(scene.time.step);
  expect_same(scene, written_and_read(scene));
}

TEST(SceneRoundTrip, IntegersAreNumbers)
{
  const Scene scene = parsed("[vesicle]\nshape = \"prolate\"\nreduced_volume = 1\nradius = 2");
  EXPECT_EQ(scene.vesicle.radius, 2.0);
  EXPECT_EQ(scene.time.output_every, 2.0);
  expect_same(scene, written_and_read(scene));
}

TEST(SceneRoundTrip, MeshPathsAreAbsoluteAndKeepTheirLetters)
{
  const Scene scene =
    parsed("[vesicle]\nfile = \"../mesh \\\"é\\\\.vtu\"\nmerge = 1e-9\nradius = 2\ntriangles = "
           "500\nrotation = [0, 3, 0, 90]");
  EXPECT_EQ(scene.vesicle.mesh_file, "/mesh \"é\\.vtu");
  EXPECT_EQ(scene.vesicle.mesh_merge, 1e-9);
  EXPECT_EQ(scene.vesicle.mesh_radius, 2.0);
  EXPECT_EQ(scene.vesicle.mesh_triangles, 500);
  EXPECT_EQ(*scene.vesicle.rotation, (std::array{ 0.0, 1.0, 0.0, 90.0 }));
  expect_same(scene, written_and_read(scene));
}

TEST(SceneRoundTrip, ControlLettersInStrings)
{
  const Scene scene = parsed("[vesicle]\nfile = \"a\\tb\\u007F\\nc\"");
  expect_same(scene, written_and_read(scene));
}

TEST(SceneRoundTrip, EveryReferenceShape)
{
  using Reference = Scene::Membrane::Reference;
  const auto membrane_of = [](const std::string& reference)
  {
    const Scene scene = parsed("[vesicle]\nshape = \"discocyte\"\n[membrane]\nshear_modulus = 2\n"
                               "elasticity = \"skalak\"\nsurface_viscosity = 3\n" +
      reference + "\n[accuracy]\nmesh_motion = \"material\"");
    expect_same(scene, written_and_read(scene));
    EXPECT_EQ(scene.membrane.surface_viscosity, 3);
    return scene.membrane;
  };
  EXPECT_EQ(membrane_of("").reference, Reference::start);
  EXPECT_EQ(membrane_of("reference = \"start\"").reference, Reference::start);
  EXPECT_EQ(membrane_of("reference = \"sphere\"").reference, Reference::sphere);
  const Scene::Membrane from_file = membrane_of("reference = \"unstressed.vtu\"");
  EXPECT_EQ(from_file.reference, Reference::file);
  EXPECT_EQ(from_file.reference_file, "/scenes/unstressed.vtu");
}

TEST(SceneRoundTrip, EveryFlow)
{
  const std::string sphere = "[vesicle]\nshape = \"sphere\"\n[flow]\n";
  const auto flow_of = [&](const std::string& text)
  {
    const Scene scene = parsed(sphere + text);
    expect_same(scene, written_and_read(scene));
    return scene.flow;
  };
  const auto uniform = flow_of("kind = \"uniform\"\nvelocity = [1, 2, -3.5]");
  EXPECT_EQ(dynamic_cast<const Uniform&>(*uniform).velocity, Vector3(1, 2, -3.5));

  const auto shear = flow_of("kind = \"shear\"\nrate = -2");
  EXPECT_EQ(dynamic_cast<const Shear&>(*shear).rate, -2);

  const auto planar = flow_of("kind = \"extension\"\ntype = \"planar\"\nrate = 0.1");
  EXPECT_EQ(dynamic_cast<const Extension&>(*planar).type, Extension::Type::planar);
  EXPECT_EQ(dynamic_cast<const Extension&>(*planar).rate, 0.1);

  const auto axial = flow_of("kind = \"extension\"\ntype = \"axisymmetric\"\nrate = 0.1");
  EXPECT_EQ(dynamic_cast<const Extension&>(*axial).type, Extension::Type::axisymmetric);

  const auto tube = flow_of(
    "kind = \"poiseuille\"\nvelocity = 0.3\nradius = 5\naxis = [0, 3, 4]\ncenter = [0, 0, 0.1]");
  const auto& poiseuille = dynamic_cast<const Poiseuille&>(*tube);
  EXPECT_EQ(poiseuille.velocity, 0.3);
  EXPECT_EQ(poiseuille.radius, 5);
  EXPECT_LT((poiseuille.axis - Vector3(0, 0.6, 0.8)).norm(), 1e-15);
  EXPECT_EQ(poiseuille.center, Vector3(0, 0, 0.1));
}

TEST(SceneRoundTrip, EverySetting)
{
  const Scene scene = parse_scene(R"(
    name = "All_of-it.2"
    [vesicle]
    shape = "perturbed"
    modes = [[2, -1, 0.1], [4, 0, -1e-3]]
    radius = 1e-5
    triangles = 320
    rotation = [1, 1, 1, 30]
    center = [0.1, -0.0, 1e-300]
    [membrane]
    bending_rigidity = 1.7e-19
    spontaneous_curvature = -2.5e5
    area_difference_stiffness = 1.4
    area_difference = 1.2
    incompressible = false
    [fluid]
    viscosity = 1e-3
    [gravity]
    density_difference = 20
    acceleration = 9.81
    [time]
    end = "steady"
    output_every = 0.1
    step = 0.004
    tolerance = 1e-5
    [accuracy]
    preset = "accurate"
    basis = "linear"
    bending = "cotan"
    integrator = "imex-euler"
    mesh_motion = "material"
    quadrature = 12
    operator = "dense"
    precision = "double"
    tree_tolerance = 1e-6
    linear_tolerance = 1e-8
    [movie]
    color = "Tension"
    range = [-1, 2.5]
    size = [640, 480]
    view = "iso"
    camera = "fixed"
    smooth = true
    arrows = true
    flow_lines = true
    markers = 40
    edges = true
    chart = "velocity"
    [output]
    fields = ["Tension", "Velocity"]
    directory = "runs/x"
  )",
    "all.toml", "/scenes");
  EXPECT_EQ(scene.output.directory, "/scenes/runs/x");
  EXPECT_TRUE(std::signbit(scene.vesicle.center[1]));
  const Scene again = written_and_read(scene);
  expect_same(scene, again);
  EXPECT_TRUE(std::signbit(again.vesicle.center[1]));
}

TEST(SceneRoundTrip, AnyNumberBitForBit)
{
  Scene scene = parsed("[vesicle]\nshape = \"sphere\"");
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-307, 307), fraction(1, 10);
  std::vector<double> numbers{ 0.1, 1.0 / 3, 1e22, 123456789012345680.0, 5e-324,
    std::numeric_limits<double>::max(), std::numeric_limits<double>::min() };
  for (int i = 0; i < 500; ++i)
  {
    numbers.push_back(fraction(random) * std::pow(10.0, exponent(random)));
  }
  for (const double number : numbers)
  {
    scene.fluid.viscosity = number;
    EXPECT_EQ(written_and_read(scene).fluid.viscosity, number);
  }
}

TEST(SceneRoundTrip, AnyDirectionBitForBit)
{
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 500; ++i)
  {
    const std::string axis = std::to_string(normal(random)) + ", " +
      std::to_string(normal(random)) + ", " + std::to_string(normal(random));
    const Scene scene =
      parsed("[vesicle]\nshape = \"prolate\"\nreduced_volume = 0.9\naxis = [" + axis + "]");
    EXPECT_NEAR(scene.vesicle.axis.norm(), 1, 1e-15);
    EXPECT_EQ(written_and_read(scene).vesicle.axis, scene.vesicle.axis);
  }
}

TEST(SceneRoundTrip, TinyAndHugeDirections)
{
  for (const std::string size : { "1e-200", "1e200", "5e-324" })
  {
    const Scene scene =
      parsed("[vesicle]\nshape = \"prolate\"\nreduced_volume = 0.9\naxis = [" + size + ", 0, 0]");
    EXPECT_EQ(scene.vesicle.axis, Vector3(1, 0, 0));
  }
}
