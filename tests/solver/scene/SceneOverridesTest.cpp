#include "solver/Errors.h"
#include "solver/flow/Shear.h"
#include "solver/scene/SceneFile.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace vesicle;

namespace
{

const std::string shear = R"(
name = "here"
[vesicle]
shape = "prolate"
reduced_volume = 0.9
[flow]
kind = "shear"
rate = 1
[time]
end = 3
output_every = 0.1
)";

Scene with(const std::vector<std::string>& overrides)
{
  return parse_scene(shear, "s.toml", "/scenes", overrides);
}

std::string error_with(const std::vector<std::string>& overrides)
{
  try
  {
    with(overrides);
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "no error";
}

double rate_of(const Scene& scene)
{
  return dynamic_cast<const Shear&>(*scene.flow).rate;
}

}

TEST(SceneOverrides, NumbersMayBeginOrEndWithTheirPoint)
{
  EXPECT_EQ(rate_of(with({ "flow.rate=.5" })), 0.5);
  EXPECT_EQ(rate_of(with({ "flow.rate=5." })), 5);
  EXPECT_EQ(rate_of(with({ "flow.rate=-.5e1" })), -5);
}

TEST(SceneOverrides, ReplaceAndAdd)
{
  const Scene scene = with({ "flow.rate=2.5", "time.end=steady", "fluid.viscosity=3",
    "vesicle.axis=[1, 0, 1]", "membrane.incompressible=false", "name=other" });
  EXPECT_EQ(rate_of(scene), 2.5);
  EXPECT_FALSE(scene.time.end);
  EXPECT_EQ(scene.fluid.viscosity, 3);
  EXPECT_EQ(scene.vesicle.axis, Vector3(1, 0, 1).normalized());
  EXPECT_FALSE(scene.membrane.incompressible);
  EXPECT_EQ(scene.name, "other");
}

TEST(SceneOverrides, LaterOnesWin)
{
  EXPECT_EQ(rate_of(with({ "flow.rate=2", "flow.rate=4" })), 4);
}

TEST(SceneOverrides, WordsNeedNoQuotes)
{
  EXPECT_EQ(with({ "accuracy.preset=fast" }).accuracy.preset, Scene::Preset::fast);
  EXPECT_EQ(with({ "accuracy.preset=\"fast\"" }).accuracy.preset, Scene::Preset::fast);
  EXPECT_EQ(with({ "name=2024" }).name, "2024");
  EXPECT_EQ(with({ "name=007" }).name, "007");
  EXPECT_EQ(*with({ "output.directory=/tmp/a=b" }).output.directory, "/tmp/a=b");
}

TEST(SceneOverrides, MistakesNameTheOverride)
{
  EXPECT_EQ(error_with({ "flow.rate=abc" }),
    "--set flow.rate=abc: key 'flow.rate': must be a number, is the string \"abc\"; allowed: a "
    "finite "
    "number");
  EXPECT_EQ(error_with({ "fluid.viscosity=-1" }),
    "--set fluid.viscosity=-1: key 'fluid.viscosity': can't be -1; allowed: a number > 0");
  EXPECT_EQ(error_with({ "flow.rte=1" }),
    "--set flow.rte=1: key 'flow.rte': unknown key, did you mean 'rate'?; allowed: kind, rate, "
    "history, period, angular_frequency");
  EXPECT_EQ(error_with({ "gravty.bond_number=1" })
              .find("--set gravty.bond_number=1: key 'gravty': unknown "
                    "table, did you mean [gravity]?; allowed: "),
    0u);
  EXPECT_EQ(error_with({ "gravity.acceleration=1" })
              .find("--set gravity.acceleration=1: key "
                    "'gravity.density_difference': is missing"),
    0u);
  EXPECT_EQ(error_with({ "vesicle.axis=[0,0" })
              .find("--set vesicle.axis=[0,0: the value is not valid TOML"),
    0u);
}

TEST(SceneOverrides, MustHaveAKeyAndAValue)
{
  for (const std::string text :
    { "", "flow.rate", "=3", "flow.=3", ".rate=3", "flow.rate=", "a.b.c=3" })
  {
    const std::string error = error_with({ text });
    EXPECT_EQ(error.find("--set " + text + ": is not an override; allowed: table.key=value"), 0u)
      << error;
  }
}

TEST(SceneOverrides, CannotSmuggleInASecondKey)
{
  EXPECT_NE(error_with({ "flow.rate=1\nb = 2" }), "no error");
}
