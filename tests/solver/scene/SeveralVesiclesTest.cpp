// Scenes with several vesicles: [[vesicle]] tables, tables of their own in them, what is refused.

#include "solver/Errors.h"
#include "solver/scene/SceneFile.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace vesicle;

namespace
{

const std::string time_table = "[time]\nend = 1\noutput_every = 0.1\n";

const std::string pair = R"(
[[vesicle]]
shape = "prolate"
reduced_volume = 0.9
center = [-2, 0, 0]
[[vesicle]]
shape = "sphere"
triangles = 320
center = [2, 0, 0]
[vesicle.membrane]
incompressible = false
[vesicle.fluid]
viscosity_ratio = 4
[vesicle.gravity]
bond_number = -3
[membrane]
bending_rigidity = 2
[fluid]
viscosity = 5
[gravity]
bond_number = 7
)" +
  time_table;

Scene parsed(const std::string& text, const std::vector<std::string>& overrides = {})
{
  return parse_scene(text, "s.toml", "/scenes", overrides);
}

std::string error_of(const std::string& text, const std::vector<std::string>& overrides = {})
{
  try
  {
    parsed(text, overrides);
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "no error";
}

}

TEST(SeveralVesicles, HaveTheirOwnShapesAndTables)
{
  const Scene scene = parsed(pair);
  ASSERT_EQ(scene.vesicles(), 2u);
  EXPECT_EQ(scene.vesicle.shape.kind, ShapeRequest::Kind::prolate);
  EXPECT_EQ(scene.membrane.bending_rigidity, 2);
  EXPECT_EQ(scene.fluid.viscosity_ratio, 1);
  const Scene::Companion& other = scene.companions[0];
  EXPECT_EQ(other.vesicle.shape.kind, ShapeRequest::Kind::sphere);
  EXPECT_EQ(other.vesicle.shape.triangles, 320);
  EXPECT_EQ(other.vesicle.center, Vector3(2, 0, 0));
  EXPECT_FALSE(other.membrane.bending_rigidity); // the whole table is another
  EXPECT_FALSE(other.membrane.incompressible);
  EXPECT_EQ(other.viscosity_ratio, 4);
  EXPECT_EQ(other.gravity->bond_number, -3);
}

TEST(SeveralVesicles, EachAloneIsAScene)
{
  const Scene scene = parsed(pair);
  const Scene first = scene.alone(0), second = scene.alone(1);
  EXPECT_EQ(first.vesicles(), 1u);
  EXPECT_EQ(first.vesicle.shape.kind, ShapeRequest::Kind::prolate);
  EXPECT_EQ(second.vesicles(), 1u);
  EXPECT_EQ(second.vesicle.shape.triangles, 320);
  EXPECT_FALSE(second.membrane.bending_rigidity);
  EXPECT_EQ(second.fluid.viscosity, 5);
  EXPECT_EQ(second.fluid.viscosity_ratio, 4);
  EXPECT_EQ(second.gravity->bond_number, -3);
}

// Reading what was written gives the same text again, whoever has which table.
TEST(SeveralVesicles, AreWrittenAndReadAgain)
{
  const std::string only_the_first_falls =
    "[[vesicle]]\nshape = \"sphere\"\n[vesicle.gravity]\n"
    "bond_number = 1\n[[vesicle]]\nshape = \"sphere\"\n"
    "[[vesicle]]\nfile = \"/mesh.stl\"\ncenter = [1, 2, 3]\n" +
    time_table;
  for (const std::string& text : { pair, only_the_first_falls })
  {
    const Scene scene = parsed(text);
    const std::string written = write_scene(scene);
    const Scene again = parsed(written);
    EXPECT_EQ(write_scene(again), written);
    ASSERT_EQ(again.vesicles(), scene.vesicles());
    for (std::size_t v = 0; v < scene.vesicles(); ++v)
    {
      EXPECT_EQ(write_scene(again.alone(v)), write_scene(scene.alone(v)));
      EXPECT_EQ(again.alone(v).gravity.has_value(), scene.alone(v).gravity.has_value());
    }
  }
}

TEST(SeveralVesicles, OneInAnArrayIsOne)
{
  const std::string keys = "shape = \"sphere\"\n[vesicle.membrane]\nincompressible = false\n";
  const Scene table = parsed("[vesicle]\n" + keys + time_table),
              array = parsed("[[vesicle]]\n" + keys + time_table);
  EXPECT_EQ(write_scene(table), write_scene(array));
  EXPECT_FALSE(array.membrane.incompressible);
  EXPECT_EQ(error_of("[vesicle]\nshap = 1\n" + time_table),
    error_of("[[vesicle]]\nshap = 1\n" + time_table));
}

TEST(SeveralVesicles, OverridesNameOneOrAll)
{
  const Scene one = parsed(pair, { "vesicle.1.triangles=1280" });
  EXPECT_EQ(one.vesicle.shape.triangles, ShapeRequest{}.triangles);
  EXPECT_EQ(one.companions[0].vesicle.shape.triangles, 1280);
  const Scene all = parsed(pair, { "vesicle.triangles=80" });
  EXPECT_EQ(all.vesicle.shape.triangles, 80);
  EXPECT_EQ(all.companions[0].vesicle.shape.triangles, 80);
  const Scene own = parsed(pair, { "vesicle.0.membrane.spontaneous_curvature=3" });
  EXPECT_EQ(own.membrane.spontaneous_curvature, 3);
  EXPECT_EQ(own.membrane.bending_rigidity, 2); // the rest of the scene's table stays
  const std::string single = "[vesicle]\nshape = \"sphere\"\n" + time_table;
  EXPECT_EQ(parsed(single, { "vesicle.0.triangles=80" }).vesicle.shape.triangles, 80);
}

TEST(SeveralVesicles, MistakesNameTheVesicle)
{
  EXPECT_EQ(error_of(pair, { "vesicle.2.triangles=80" }),
    "--set vesicle.2.triangles=80: there is no vesicle 2; allowed: 0 to 1");
  EXPECT_EQ(error_of(pair, { "vesicle.1.flow.rate=80" }),
    "--set vesicle.1.flow.rate=80: a vesicle has no table 'flow' of its own; allowed: membrane, "
    "fluid, gravity");
  EXPECT_EQ(error_of(pair, { "vesicle.fluid.viscosity=3" }),
    "--set vesicle.fluid.viscosity=3: is one for all vesicles; allowed: fluid.viscosity");
  EXPECT_EQ(error_of(pair, { "vesicle.1.triangles=3" })
              .find("--set vesicle.1.triangles=3: key 'vesicle.1.triangles': can't be 3"),
    0u);
  const std::string first = "[[vesicle]]\nshape = \"sphere\"\n[[vesicle]]\n";
  EXPECT_EQ(error_of(first + "shap = 1\n" + time_table).find("s.toml:4: key 'vesicle.1.shap'"), 0u);
  EXPECT_EQ(error_of(first + time_table).find("s.toml:3: key 'vesicle.1.shape': is missing"), 0u);
  EXPECT_EQ(
    error_of(first + "shape = \"sphere\"\n[vesicle.membrane]\nshear_modulus = -1\n" + time_table)
      .find("s.toml:6: key 'vesicle.1.membrane.shear_modulus': can't be -1"),
    0u);
  EXPECT_EQ(error_of(first + "shape = \"sphere\"\n[vesicle.fluid]\nviscosity = 2\n" + time_table),
    "s.toml:6: key 'vesicle.1.fluid.viscosity': is one for all vesicles; allowed: [fluid] "
    "viscosity");
  EXPECT_EQ(error_of("vesicle = []\n" + time_table)
              .find("s.toml:1: key 'vesicle': must be a table, is an array of 0"),
    0u);
  EXPECT_EQ(error_of("[vesicle]\nshape = \"sphere\"\n[vesicle]\nshape = \"sphere\"\n" + time_table),
    "s.toml:3: '[vesicle]' is in line 1 already; allowed: each once, or [[vesicle]] for each of "
    "several vesicles");
}

// What each vesicle must keep to, all must.
TEST(SeveralVesicles, AreCheckedOneByOne)
{
  const std::string two =
    "[[vesicle]]\nshape = \"sphere\"\n[[vesicle]]\nshape = \"sphere\"\n[vesicle.membrane]\n"
    "shear_modulus = 1\n";
  EXPECT_NE(error_of(two + time_table).find("key 'accuracy.mesh_motion'"), std::string::npos);
  EXPECT_EQ(error_of(two + time_table + "[accuracy]\nmesh_motion = \"material\"\n"), "no error");
}

TEST(SeveralVesicles, RefuseWhatIsForOne)
{
  const std::string two = "[[vesicle]]\nshape = \"sphere\"\n[[vesicle]]\nshape = \"sphere\"\n";
  EXPECT_EQ(error_of(two + "[accuracy]\nmesh_motion = \"adaptive\"\n" + time_table),
    "s.toml:6: key 'accuracy.mesh_motion': \"adaptive\" lays the mesh of one vesicle anew, and "
    "there are 2; allowed: \"equidistribute\", \"material\"");
  EXPECT_EQ(error_of(two + "[accuracy]\npreset = \"fast\"\n" + time_table)
              .find("s.toml:6: key 'accuracy.preset': flat triangles feel one vesicle only, and "
                    "there are 2; allowed: "),
    0u);
  EXPECT_EQ(error_of(two + "[membrane]\nbending_rigidity = 1\n[time]\nend = \"equilibrium\"\n")
              .find("s.toml:8: key 'time.end': an equilibrium is that of one vesicle, and there "
                    "are 2; allowed: "),
    0u);
}
