// Every way of getting a scene wrong: the message has the file, the line, the key, what is wrong
// and what is allowed.

#include "solver/scene/SceneFile.h"

#include "tests/solver/scene/SceneError.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

using namespace vesicle;
using test::error_of;

namespace
{

struct Case
{
  std::string name;
  std::string toml;
  std::vector<std::string> message; ///< parts, in order
};

void PrintTo(const Case& c, std::ostream* out)
{
  *out << c.name;
}

/// A scene that is right except for what stands in `tables`.
std::string with_time(const std::string& tables)
{
  return tables + "\n[time]\nend = 1\noutput_every = 0.1\n";
}

/// `line` is the third line.
std::string in_vesicle(const std::string& line)
{
  return with_time("[vesicle]\nshape = \"prolate\"\n" + line +
    (line.starts_with("reduced_volume") ? "" : "\nreduced_volume = 0.9"));
}

std::string with_sphere(const std::string& tables)
{
  return with_time("[vesicle]\nshape = \"sphere\"\n" + tables);
}

std::string in_time(const std::string& lines)
{
  return "[vesicle]\nshape = \"sphere\"\n[time]\n" + lines;
}

const std::vector<Case> cases{
  { "syntax", "[vesicle]\nshape = = 3\n", { "s.toml:2: not valid TOML", "allowed:" } },
  { "twice", "[vesicle]\nshape = \"sphere\"\nshape = \"sphere\"\n",
    { "s.toml:3: 'shape' is in line 2 already" } },
  { "empty", "",
    { "s.toml:1: key 'vesicle.shape': is missing; allowed: \"sphere\", \"prolate\"" } },

  { "unknown_table", with_sphere("[fluidd]\nviscosity = 1"),
    { "s.toml:3: key 'fluidd': unknown table, did you mean [fluid]?; allowed: name, [vesicle], "
      "[membrane]" } },
  { "unknown_top_key", "nmae = \"x\"\n" + with_sphere(""),
    { "s.toml:1: key 'nmae': unknown key, did you mean 'name'?; allowed: name, units, "
      "[vesicle]" } },
  { "table_wanted", "flow = 3\n" + with_sphere(""),
    { "s.toml:1: key 'flow': must be a table, is the integer 3; allowed: [flow]" } },
  { "table_array", with_sphere("[[flow]]\nkind = \"shear\""),
    { "s.toml:3: key 'flow': must be a table" } },
  { "unknown_key", with_sphere("[fluid]\nviscosty = 1"),
    { "s.toml:4: key 'fluid.viscosty': unknown key, did you mean 'viscosity'?; allowed: "
      "viscosity" } },
  { "unknown_key_far", with_sphere("[fluid]\nq = 1"),
    { "s.toml:4: key 'fluid.q': unknown key; allowed: viscosity" } },
  { "subtable", with_sphere("[flow]\nkind = \"shear\"\nrate = 1\n[flow.shear]\nx = 1"),
    { "s.toml:6: key 'flow.shear': unknown key" } },

  { "name_path", "name = \"a/b\"\n" + with_sphere(""),
    { "s.toml:1: key 'name': \"a/b\" can't be used as a file name; allowed: letters, digits" } },
  { "name_dots", "name = \"..\"\n" + with_sphere(""),
    { "s.toml:1: key 'name': \"..\" can't be used" } },
  { "name_empty", "name = \"\"\n" + with_sphere(""),
    { "s.toml:1: key 'name': \"\" can't be used" } },
  { "name_number", "name = 3\n" + with_sphere(""),
    { "s.toml:1: key 'name': must be a string, is the integer 3; allowed: a string" } },

  { "shape_missing", with_time("[vesicle]\nradius = 1"),
    { "s.toml:1: key 'vesicle.shape': is missing; allowed: ",
      "\"stomatocyte\", or 'file' with a mesh" } },
  { "shape_missing_typo", with_time("[vesicle]\nshpae = \"sphere\""),
    { "s.toml:2: key 'vesicle.shpae': unknown key, did you mean 'shape'?; allowed: shape" } },
  { "shape_unknown", with_time("[vesicle]\nshape = \"prolat\""),
    { "s.toml:2: key 'vesicle.shape': can't be \"prolat\", did you mean \"prolate\"?; allowed: "
      "\"sphere\", \"prolate\", \"oblate\", \"ellipsoid\", \"discocyte\", \"perturbed\", "
      "\"stomatocyte\"" } },
  { "shape_type", with_time("[vesicle]\nshape = 1"),
    { "s.toml:2: key 'vesicle.shape': must be a string, is the integer 1; allowed: \"sphere\"" } },
  { "shape_and_file", with_time("[vesicle]\nshape = \"sphere\"\nfile = \"a.vtu\""),
    { "s.toml:3: key 'vesicle.file': contradicts 'shape'", "allowed: file or shape" } },
  { "file_type", with_time("[vesicle]\nfile = 1"),
    { "s.toml:2: key 'vesicle.file': must be a string" } },
  { "file_empty", with_time("[vesicle]\nfile = \"\""),
    { "s.toml:2: key 'vesicle.file': can't be empty" } },
  { "file_with_shape_key", with_time("[vesicle]\nfile = \"a.vtu\"\nreduced_volume = 0.9"),
    { "s.toml:3: key 'vesicle.reduced_volume': does not go with 'file'; allowed: file, merge, "
      "radius, triangles, rotation" } },
  { "key_of_other_shape", with_time("[vesicle]\nshape = \"sphere\"\nsemi_axes = [1, 1, 1]"),
    { "s.toml:3: key 'vesicle.semi_axes': does not go with shape = \"sphere\"; allowed: shape, "
      "radius" } },
  { "modes_of_other_shape", in_vesicle("modes = [[2, 0, 0.1]]"),
    { "s.toml:3: key 'vesicle.modes': does not go with shape = \"prolate\"" } },
  { "sphere_deflated", with_time("[vesicle]\nshape = \"sphere\"\nreduced_volume = 0.9"),
    { "s.toml:3: key 'vesicle.reduced_volume': does not go with shape = \"sphere\"" } },
  { "volume_missing", with_time("[vesicle]\nshape = \"prolate\""),
    { "s.toml:1: key 'vesicle.reduced_volume': is missing; allowed: a number > 0 and <= 1" } },
  { "volume_zero", in_vesicle("reduced_volume = 0"),
    { "s.toml:3: key 'vesicle.reduced_volume': can't be 0; allowed: a number > 0 and <= 1" } },
  { "volume_above_one", in_vesicle("reduced_volume = 1.01"),
    { "s.toml:3: key 'vesicle.reduced_volume': can't be 1.01; allowed: a number > 0 and <= 1" } },
  { "volume_nan", in_vesicle("reduced_volume = nan"),
    { "s.toml:3: key 'vesicle.reduced_volume': can't be nan" } },
  { "volume_text", in_vesicle("reduced_volume = \"0.9\""),
    { "s.toml:3: key 'vesicle.reduced_volume': must be a number, is the string \"0.9\"; "
      "allowed: " } },
  { "triangles_few", in_vesicle("triangles = 19"),
    { "s.toml:3: key 'vesicle.triangles': can't be 19; allowed: an integer from 20" } },
  { "triangles_float", in_vesicle("triangles = 1280.0"),
    { "s.toml:3: key 'vesicle.triangles': must be an integer, is the number 1280; allowed: " } },
  { "triangles_huge", in_vesicle("triangles = 5000000000"),
    { "s.toml:3: key 'vesicle.triangles': can't be 5000000000" } },
  { "radius_zero", in_vesicle("radius = 0.0"),
    { "s.toml:3: key 'vesicle.radius': can't be 0; allowed: a number > 0" } },
  { "radius_inf", in_vesicle("radius = inf"), { "s.toml:3: key 'vesicle.radius': can't be inf" } },
  { "radius_flag", in_vesicle("radius = true"),
    { "s.toml:3: key 'vesicle.radius': must be a number, is true" } },
  { "radius_date", in_vesicle("radius = 2020-01-01"),
    { "s.toml:3: key 'vesicle.radius': must be a number, is a date or time" } },
  { "axis_zero", in_vesicle("axis = [0, 0, 0.0]"),
    { "s.toml:3: key 'vesicle.axis': can't be the zero vector; allowed: [x, y, z], not all 0" } },
  { "axis_short", in_vesicle("axis = [0, 1]"),
    { "s.toml:3: key 'vesicle.axis': must be an array of 3, is an array of 2; allowed: an array of "
      "3, "
      "each a finite number" } },
  { "axis_number", in_vesicle("axis = 1"),
    { "s.toml:3: key 'vesicle.axis': must be an array of 3, is the integer 1" } },
  { "axis_word", in_vesicle("axis = [\"x\", 0, 0]"),
    { "s.toml:3: key 'vesicle.axis': must be a number, is the string \"x\"" } },
  { "axis_inf", in_vesicle("axis = [inf, 0, 0]"),
    { "s.toml:3: key 'vesicle.axis': can't be inf" } },
  { "axis_and_rotation", in_vesicle("rotation = [0, 0, 1, 90]\naxis = [1, 0, 0]"),
    { "s.toml:3: key 'vesicle.rotation': contradicts 'axis'", "allowed: rotation or axis" } },
  { "rotation_zero", in_vesicle("rotation = [0, 0, 0, 90]"),
    { "s.toml:3: key 'vesicle.rotation': its axis can't be the zero vector" } },
  { "rotation_short", in_vesicle("rotation = [0, 0, 1]"),
    { "s.toml:3: key 'vesicle.rotation': must be an array of 4, is an array of 3" } },
  { "semi_axes_missing", with_time("[vesicle]\nshape = \"ellipsoid\""),
    { "s.toml:1: key 'vesicle.semi_axes': is missing; allowed: [a, b, c], each a number > 0" } },
  { "semi_axes_negative", with_time("[vesicle]\nshape = \"ellipsoid\"\nsemi_axes = [1, -1, 1]"),
    { "s.toml:3: key 'vesicle.semi_axes': can't be -1; allowed: a number > 0" } },
  { "modes_missing", with_time("[vesicle]\nshape = \"perturbed\""),
    { "s.toml:1: key 'vesicle.modes': is missing; allowed: [[l, m, amplitude], …]" } },
  { "modes_empty", with_time("[vesicle]\nshape = \"perturbed\"\nmodes = []"),
    { "s.toml:3: key 'vesicle.modes': can't be empty" } },
  { "modes_flat", with_time("[vesicle]\nshape = \"perturbed\"\nmodes = [2, 0, 0.1]"),
    { "s.toml:3: key 'vesicle.modes': must be an array of 3, is the integer 2" } },
  { "modes_order",
    with_time("[vesicle]\nshape = \"perturbed\"\nmodes = [\n[2, 0, 0.1],\n[2, -3, 0.1]]"),
    { "s.toml:5: key 'vesicle.modes': can't have m = -3 with l = 2; allowed: [[l, m, amplitude], "
      "…]" } },
  { "modes_degree", with_time("[vesicle]\nshape = \"perturbed\"\nmodes = [[-2, 0, 0.1]]"),
    { "s.toml:3: key 'vesicle.modes': can't be -2; allowed: an integer >= 0" } },
  { "modes_real_degree", with_time("[vesicle]\nshape = \"perturbed\"\nmodes = [[2.5, 0, 0.1]]"),
    { "s.toml:3: key 'vesicle.modes': must be an integer, is the number 2.5" } },

  { "key_twice", with_sphere("[fluid]\nviscosity = 1\nviscosity = 2"),
    { "s.toml:5: 'viscosity' is in line 4 already; allowed: each once" } },
  { "table_twice", with_sphere("[fluid]\nviscosity = 1\n[ fluid ]\nviscosity = 2"),
    { "s.toml:5: '[fluid]' is in line 3 already; allowed: each once" } },

  { "bending_negative", with_sphere("[membrane]\nbending_rigidity = -1"),
    { "s.toml:4: key 'membrane.bending_rigidity': can't be -1; allowed: a number > 0; leave the "
      "key out" } },
  { "curvature_without_bending", with_sphere("[membrane]\nspontaneous_curvature = 1"),
    { "s.toml:4: key 'membrane.spontaneous_curvature': does nothing without bending; allowed: a "
      "number, beside bending_rigidity" } },
  { "area_difference_without_bending", with_sphere("[membrane]\narea_difference_stiffness = 1"),
    { "s.toml:4: key 'membrane.area_difference_stiffness': is counted in the bending rigidity, "
      "which isn't there; allowed: a number > 0, beside bending_rigidity" } },
  { "area_difference_alone", with_sphere("[membrane]\narea_difference = 1"),
    { "s.toml:4: key 'membrane.area_difference': does nothing without area_difference_stiffness; "
      "allowed: a number, beside area_difference_stiffness" } },
  { "reference_of_a_fluid", with_sphere("[membrane]\nreference = \"sphere\""),
    { "s.toml:4: key 'membrane.reference': does nothing without shear_modulus; allowed: it beside "
      "shear_modulus" } },
  { "reference_empty", with_sphere("[membrane]\nshear_modulus = 1\nreference = \"\""),
    { "s.toml:5: key 'membrane.reference': can't be empty; allowed: \"start\", \"sphere\" or the "
      "path of a mesh" } },
  { "surface_viscosity_negative", with_sphere("[membrane]\nsurface_viscosity = -1"),
    { "s.toml:4: key 'membrane.surface_viscosity': can't be -1; allowed: a number >= 0" } },
  { "surface_viscosity_of_flat_triangles",
    with_sphere("[membrane]\nsurface_viscosity = 1\n[accuracy]\npreset = \"fast\""),
    { "s.toml:6: key 'accuracy.preset': has no viscosity of the membrane, and "
      "membrane.surface_viscosity isn't 0; allowed: \"balanced\" or \"accurate\", or basis = "
      "\"loop\"" } },
  { "incompressible_number", with_sphere("[membrane]\nincompressible = 1"),
    { "s.toml:4: key 'membrane.incompressible': must be true or false, is the integer 1; allowed: "
      "true, "
      "false" } },
  { "viscosity_negative", with_sphere("[fluid]\nviscosity = -0.5"),
    { "s.toml:4: key 'fluid.viscosity': can't be -0.5; allowed: a number > 0" } },

  { "flow_kind_missing", with_sphere("[flow]\nrate = 1"),
    { "s.toml:3: key 'flow.kind': is missing; allowed: \"uniform\", \"shear\"" } },
  { "flow_kind_unknown", with_sphere("[flow]\nkind = \"sheer\""),
    { "s.toml:4: key 'flow.kind': can't be \"sheer\", did you mean \"shear\"?; allowed: "
      "\"uniform\", "
      "\"shear\", \"extension\", \"poiseuille\"" } },
  { "flow_rate_missing", with_sphere("[flow]\nkind = \"shear\""),
    { "s.toml:3: key 'flow.rate': is missing; allowed: a finite number" } },
  { "flow_key_of_other_kind", with_sphere("[flow]\nkind = \"shear\"\nrate = 1\nradius = 2"),
    { "s.toml:6: key 'flow.radius': does not go with kind = \"shear\"; allowed: kind, rate" } },
  { "flow_type_missing", with_sphere("[flow]\nkind = \"extension\"\nrate = 1"),
    { "s.toml:3: key 'flow.type': is missing; allowed: \"planar\"" } },
  { "flow_type_unknown", with_sphere("[flow]\nkind = \"extension\"\nrate = 1\ntype = \"axial\""),
    { "s.toml:6: key 'flow.type': can't be \"axial\"", "allowed: \"planar\", \"axisymmetric\"" } },
  { "flow_velocity_number", with_sphere("[flow]\nkind = \"uniform\"\nvelocity = 1"),
    { "s.toml:5: key 'flow.velocity': must be an array of 3" } },
  { "flow_velocity_vector",
    with_sphere("[flow]\nkind = \"poiseuille\"\nradius = 3\nvelocity = [1, 0, 0]"),
    { "s.toml:6: key 'flow.velocity': must be a number, is an array of 3" } },
  { "flow_radius_missing", with_sphere("[flow]\nkind = \"poiseuille\"\nvelocity = 1"),
    { "s.toml:3: key 'flow.radius': is missing; allowed: a number > 0" } },
  { "flow_axis_zero",
    with_sphere("[flow]\nkind = \"poiseuille\"\nvelocity = 1\nradius = 2\naxis = [0, 0, 0]"),
    { "s.toml:7: key 'flow.axis': can't be the zero vector" } },

  { "gravity_empty", with_sphere("[gravity]"),
    { "s.toml:3: key 'gravity.bond_number': is missing; allowed: bond_number, or both "
      "density_difference and acceleration" } },
  { "gravity_both", with_sphere("[gravity]\nbond_number = 1\nacceleration = 1"),
    { "s.toml:4: key 'gravity.bond_number': contradicts", "allowed: bond_number, or both" } },
  { "gravity_half", with_sphere("[gravity]\nacceleration = 1"),
    { "s.toml:3: key 'gravity.density_difference': is missing; allowed: bond_number, or both" } },
  { "gravity_other_half", with_sphere("[gravity]\ndensity_difference = 1"),
    { "s.toml:3: key 'gravity.acceleration': is missing" } },

  { "time_missing", "[vesicle]\nshape = \"sphere\"\n", { "s.toml:1: key 'time.end': is missing" } },
  { "end_missing", in_time("output_every = 1\n"),
    { "s.toml:3: key 'time.end': is missing; allowed: a number > 0, \"steady\" or "
      "\"equilibrium\"" } },
  { "output_missing", in_time("end = 1\n"),
    { "s.toml:3: key 'time.output_every': is missing; allowed: a number > 0" } },
  { "end_zero", in_time("end = 0\noutput_every = 1\n"),
    { "s.toml:4: key 'time.end': can't be 0; allowed: a number > 0, \"steady\" or "
      "\"equilibrium\"" } },
  { "end_word", in_time("end = \"stedy\"\noutput_every = 1\n"),
    { "s.toml:4: key 'time.end': can't be the string \"stedy\"; allowed: a number > 0, "
      "\"steady\" or \"equilibrium\"" } },
  { "end_flag", in_time("end = true\noutput_every = 1\n"),
    { "s.toml:4: key 'time.end': must be a number, is true; allowed: a number > 0, "
      "\"steady\" or \"equilibrium\"" } },
  { "output_zero", in_time("end = 1\noutput_every = 0\n"),
    { "s.toml:5: key 'time.output_every': can't be 0; allowed: a number > 0" } },
  { "step_zero", in_time("end = 1\noutput_every = 1\nstep = 0\n"),
    { "s.toml:6: key 'time.step': can't be 0; allowed: a number > 0 or \"auto\"" } },
  { "step_word", in_time("end = 1\noutput_every = 1\nstep = \"small\"\n"),
    { "s.toml:6: key 'time.step': can't be the string \"small\"; allowed: a number > 0 or "
      "\"auto\"" } },
  { "tolerance_negative", in_time("end = 1\noutput_every = 1\ntolerance = -1e-3\n"),
    { "s.toml:6: key 'time.tolerance': can't be -0.001; allowed: a number > 0" } },

  { "preset_unknown", with_sphere("[accuracy]\npreset = \"balance\""),
    { "s.toml:4: key 'accuracy.preset': can't be \"balance\", did you mean \"balanced\"?; "
      "allowed: "
      "\"paper\", \"fast\", \"balanced\", \"accurate\"" } },
  { "wall_beside_flat_triangles", with_sphere("[wall]\n[accuracy]\npreset = \"fast\""),
    { "s.toml:5: key 'accuracy.preset': knows no walls, and the scene has a [wall]; allowed: "
      "\"balanced\" or \"accurate\"" } },
  { "wall_without_a_direction", with_sphere("[wall]\nnormal = [0, 0, 0]"),
    { "s.toml:4: key 'wall.normal': ", "; allowed: [x, y, z], not all 0" } },
  { "basis_of_the_paper", with_sphere("[accuracy]\npreset = \"paper\"\nbasis = \"loop\""),
    { "s.toml:5: key 'accuracy.basis': the paper's scheme is one of linear elements; allowed: "
      "\"linear\"" } },
  { "bending_unknown", with_sphere("[accuracy]\nbending = \"fit\""),
    { "s.toml:4: key 'accuracy.bending': can't be \"fit\"; allowed: \"cotan\", "
      "\"variational\"" } },
  { "bending_against_basis", with_sphere("[accuracy]\nbending = \"cotan\""),
    { "s.toml:4: key 'accuracy.bending': doesn't go with the basis" } },
  { "quadrature", with_sphere("[accuracy]\nquadrature = 4"),
    { "s.toml:4: key 'accuracy.quadrature': can't be 4; allowed: 1, 3, 6, 12" } },
  { "operator", with_sphere("[accuracy]\nbasis = \"linear\"\noperator = \"direct\""),
    { "accuracy.operator", "basis = \"loop\"" } },
  { "linear_tolerance", with_sphere("[accuracy]\nlinear_tolerance = 1"),
    { "s.toml:4: key 'accuracy.linear_tolerance': can't be 1; allowed: a number > 0 and < 1" } },
  { "scheme_is_no_key", with_sphere("[accuracy]\nscheme = \"paper\""),
    { "s.toml:4: key 'accuracy.scheme': unknown key" } },

  { "movie_color", with_sphere("[movie]\ncolor = \"mean_curvature\""),
    { "s.toml:4: key 'movie.color': can't be \"mean_curvature\", did you mean "
      "\"Mean_Curvature\"?; "
      "allowed: \"Mean_Curvature\", \"Gauss_Curvature\"" } },
  { "movie_range", with_sphere("[movie]\nrange = [1, 1]"),
    { "s.toml:4: key 'movie.range': its first number must be below its second; allowed: [a, b] "
      "with" } },
  { "movie_size", with_sphere("[movie]\nsize = [1280, 0]"),
    { "s.toml:4: key 'movie.size': can't be 0; allowed: an integer from 16 to 16384" } },
  { "movie_size_type", with_sphere("[movie]\nsize = \"1280x720\""),
    { "s.toml:4: key 'movie.size': must be an array of 2", "allowed: [width, height]" } },
  { "movie_view", with_sphere("[movie]\nview = \"above\""),
    { "s.toml:4: key 'movie.view': can't be \"above\"",
      "allowed: \"auto\", \"front\", \"side\", \"top\", \"iso\"" } },
  { "movie_camera", with_sphere("[movie]\ncamera = \"fixt\""),
    { "s.toml:4: key 'movie.camera': can't be \"fixt\", did you mean \"fixed\"?" } },
  { "movie_smooth", with_sphere("[movie]\nsmooth = 2"),
    { "s.toml:4: key 'movie.smooth': must be true or false" } },
  { "movie_chart", with_sphere("[movie]\nchart = \"speed\""),
    { "s.toml:4: key 'movie.chart': can't be \"speed\"",
      "allowed: \"none\", \"energy\", \"inclination\", \"velocity\", \"tension\"" } },
  { "movie_arrows", with_sphere("[movie]\narrows = \"yes\""),
    { "s.toml:4: key 'movie.arrows': must be true or false, is the string \"yes\"" } },
  { "output_field", with_sphere("[output]\nfields = [\n\"Tension\",\n\"Tensoin\"]"),
    { "s.toml:6: key 'output.fields': can't be \"Tensoin\", did you mean \"Tension\"?" } },
  { "output_fields_type", with_sphere("[output]\nfields = \"Tension\""),
    { "s.toml:4: key 'output.fields': must be an array, is the string \"Tension\"" } },
  { "output_directory", with_sphere("[output]\ndirectory = \"\""),
    { "s.toml:4: key 'output.directory': can't be empty" } },
};

class SceneErrors : public testing::TestWithParam<Case>
{
};

}

TEST_P(SceneErrors, SaysWhereWhatAndWhatIsAllowed)
{
  const std::string error = error_of(GetParam().toml);
  std::size_t from = 0;
  for (const auto& part : GetParam().message)
  {
    const auto found = error.find(part, from);
    ASSERT_NE(found, std::string::npos) << "no  " << part << "\nin  " << error;
    from = found + part.size();
  }
  EXPECT_NE(error.find("; allowed: "), std::string::npos) << error;
}

INSTANTIATE_TEST_SUITE_P(All, SceneErrors, testing::ValuesIn(cases),
  [](const testing::TestParamInfo<Case>& info) { return info.param.name; });

TEST(SceneErrors, FirstMistakeInTheFileIsReported)
{
  const std::string error = error_of(with_sphere("zz = 1\naa = 1"));
  EXPECT_TRUE(error.starts_with("s.toml:3: key 'vesicle.zz'")) << error;
}

TEST(SceneErrors, WhatCouldNotMoveAnythingIsAllowed)
{
  EXPECT_EQ(error_of(with_sphere("")), "no error");
  EXPECT_EQ(error_of(with_sphere("[gravity]\nbond_number = 0\n[flow]\nkind = \"shear\"\nrate = 0")),
    "no error");
}

TEST(SceneErrors, MissingSceneFile)
{
  EXPECT_THROW(read_scene("/no/such/scene.toml"), InputError);
  EXPECT_THROW(read_scene(std::filesystem::temp_directory_path()), InputError);
}

TEST(SceneErrors, MissingMeshIsSaidWithTheLine)
{
  const auto file = std::filesystem::path(testing::TempDir()) / "missing-mesh.toml";
  std::ofstream(file) << with_time("[vesicle]\nfile = \"nowhere.vtu\"");
  try
  {
    read_scene(file);
    FAIL() << "no error";
  }
  catch (const InputError& error)
  {
    const std::string start = file.string() + ":2: key 'vesicle.file': there is no " +
      (file.parent_path() / "nowhere.vtu").string() + "; allowed: ";
    EXPECT_TRUE(std::string(error.what()).starts_with(start)) << error.what();
  }
}
