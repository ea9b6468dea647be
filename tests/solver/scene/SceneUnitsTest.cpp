// Scenes whose values have units: the same numbers as in SI, and what doesn't fit is refused.

#include "solver/scene/Quantity.h"
#include "solver/scene/SceneFile.h"
#include "solver/scene/SceneSchema.h"

#include "tests/solver/scene/SceneError.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

using namespace vesicle;
using test::error_of;

namespace
{

const std::string with_units = R"(
[vesicle]
shape = "prolate"
reduced_volume = 0.9
radius = "10 um"
center = ["1 um", "-2 µm", 0]

[membrane]
bending_rigidity = "20 kT"

[fluid]
viscosity = "1 mPa s"
temperature = "310 K"

[flow]
kind = "shear"
rate = "2 /s"
history = [["0 s", 1], ["500 ms", 0]]

[time]
end = "1 min"
output_every = "1 s"
)";

}

TEST(SceneUnits, BecomeSi)
{
  const Scene scene = parse_scene(with_units, "s.toml");
  EXPECT_EQ(scene.units, Units::si);
  EXPECT_DOUBLE_EQ(scene.vesicle.radius, 1e-5);
  EXPECT_NEAR((scene.vesicle.center - Vector3(1e-6, -2e-6, 0)).norm(), 0, 1e-20);
  EXPECT_DOUBLE_EQ(*scene.membrane.bending_rigidity, 20 * 1.380649e-23 * 310);
  EXPECT_DOUBLE_EQ(scene.fluid.viscosity, 1e-3);
  EXPECT_DOUBLE_EQ(scene.fluid.temperature, 310);
  EXPECT_DOUBLE_EQ(scene.flow_history.table[1][0], .5);
  EXPECT_EQ(scene.flow_history.table[1][1], 0);
  EXPECT_DOUBLE_EQ(*scene.time.end, 60);
  EXPECT_DOUBLE_EQ(scene.time.output_every, 1);
}

TEST(SceneUnits, RoundTrip)
{
  const Scene scene = parse_scene(with_units, "s.toml");
  const std::string text = write_scene(scene);
  EXPECT_NE(text.find("units = \"SI\""), std::string::npos);
  EXPECT_EQ(write_scene(parse_scene(text, "s.toml")), text);
}

TEST(SceneUnits, OverridesHaveThemToo)
{
  const Scene scene = parse_scene(
    with_units, "s.toml", ".", { "vesicle.radius=5 um", "membrane.bending_rigidity=1e-19 J" });
  EXPECT_DOUBLE_EQ(scene.vesicle.radius, 5e-6);
  EXPECT_DOUBLE_EQ(*scene.membrane.bending_rigidity, 1e-19);
}

TEST(SceneUnits, PlainNumbersAreSiWhereTheSceneSaysSo)
{
  const Scene scene =
    parse_scene("units = \"SI\"\n" + with_units, "s.toml", ".", { "time.end=20" });
  EXPECT_DOUBLE_EQ(*scene.time.end, 20);
}

TEST(SceneUnits, RoomTemperatureIfNothingIsSaid)
{
  const Scene scene = parse_scene(with_units, "s.toml", ".", { "fluid.temperature=25 degC" });
  std::string without = with_units;
  without.erase(without.find("temperature"), sizeof("temperature = \"310 K\""));
  EXPECT_DOUBLE_EQ(
    *parse_scene(without, "s.toml").membrane.bending_rigidity, *scene.membrane.bending_rigidity);
}

TEST(SceneUnits, WhatDoesntFitIsRefused)
{
  EXPECT_EQ(error_of(with_units, { "vesicle.radius=10 s" }),
    "--set vesicle.radius=10 s: key 'vesicle.radius': \"10 s\" measures something else; allowed: "
    "\"10 um\" or the like");
  EXPECT_EQ(error_of(with_units, { "vesicle.radius=10 umm" }),
    "--set vesicle.radius=10 umm: key 'vesicle.radius': there is no unit \"umm\", did you mean "
    "um?; allowed: \"10 um\" or the like");
  EXPECT_EQ(error_of(with_units, { "time.end=10" }),
    "--set time.end=10: key 'time.end': has no unit, and 'membrane.bending_rigidity' has one; "
    "allowed: \"10 "
    "s\" or the like, or units = \"SI\" at the top for plain numbers in SI");
  EXPECT_EQ(error_of(with_units, { "time.end=\"10\"" }),
    "--set time.end=\"10\": key 'time.end': \"10\" measures something else; allowed: \"10 s\" or "
    "the like");
  EXPECT_EQ(error_of(with_units, { "vesicle.radius=-10 um" }),
    "--set vesicle.radius=-10 um: key 'vesicle.radius': can't be -1e-05; allowed: a number > 0");
  EXPECT_EQ(error_of(with_units, { "flow.history=[[\"0 s\", \"1 s\"]]" }),
    "--set flow.history=[[\"0 s\", \"1 s\"]]: key 'flow.history': \"1 s\" measures something else; "
    "allowed: a number without a unit");
  EXPECT_EQ(error_of("units = \"any\"\n" + with_units),
    "s.toml:1: key 'units': contradicts the units of its values; allowed: \"SI\"");
  EXPECT_EQ(error_of(with_units, { "fluid.temperature=-3 K" }),
    "--set fluid.temperature=-3 K: key 'fluid.temperature': can't be -3; allowed: a number > 0");
}

TEST(SceneUnits, ScalesMustBeGiven)
{
  const std::string scene = "[vesicle]\nshape = \"sphere\"\n[time]\nend = \"1 s\"\noutput_every = "
                            "\"1 s\"\n";
  EXPECT_EQ(error_of(scene),
    "s.toml:1: key 'vesicle.radius': is missing; allowed: the radius r0 "
    "with its unit: \"10 um\"");
  EXPECT_EQ(error_of(scene, { "vesicle.radius=10 um" }),
    "s.toml:1: key 'fluid.viscosity': is missing; allowed: that of the fluid with its unit: \"1 "
    "mPa s\"");
}

TEST(SceneUnits, ATemperatureWithoutUnitsDoesNothing)
{
  EXPECT_EQ(error_of("[vesicle]\nshape = \"sphere\"\n[fluid]\ntemperature = 300\n[time]\nend = "
                     "1\noutput_every = 1\n"),
    "s.toml:4: key 'fluid.temperature': does nothing where values have no units; allowed: it "
    "beside values with units, \"20 kT\"");
}

TEST(SceneUnits, KeysOfOneNameMeasureTheSame)
{
  for (const SceneTable& table : scene_schema())
  {
    std::map<std::string, Dimensions> known;
    for (const SceneKey& key : table.keys)
      EXPECT_EQ(
        known.try_emplace(key.name, dimensions_of(key.unit)).first->second, dimensions_of(key.unit))
        << table.name << '.' << key.name;
  }
}

/// A unit that says nothing of dimensions is one of these; others are words not understood.
TEST(SceneUnits, EveryUnitOfTheSchemaIsUnderstood)
{
  const std::vector<std::string> relative{ "", "r0", "pixels", "that of the array",
    "bending_rigidity", "shear_modulus" };
  for (const SceneTable& table : scene_schema())
    for (const SceneKey& key : table.keys)
      EXPECT_TRUE(!dimensions_of(key.unit).empty() ||
        std::find(relative.begin(), relative.end(), key.unit) != relative.end())
        << table.name << '.' << key.name << ": " << key.unit;
}
