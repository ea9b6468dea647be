// What a trade-off may look at.

#include "apps/tradeoff/Observables.h"

#include "solver/Errors.h"
#include "solver/scene/SceneFile.h"

#include <gtest/gtest.h>

namespace vesicle::tradeoff
{
namespace
{

Scene scene_of(int vesicles)
{
  std::string text;
  for (int v = 0; v < vesicles; ++v)
    text += "[[vesicle]]\nshape = \"prolate\"\nreduced_volume = 0.9\ntriangles = 80\n";
  return parse_scene(
    text + "[gravity]\nbond_number = 1\n[time]\nend = 1\noutput_every = 1\n", "test");
}

void expect_refused(const std::string& observable, int vesicles, const char* words)
{
  try
  {
    chosen_observables({ observable }, scene_of(vesicles));
    FAIL() << observable;
  }
  catch (const InputError& error)
  {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

}

TEST(TradeoffObservables, AreColumnsOfTheScenesTable)
{
  EXPECT_EQ(chosen_observables({ "area" }, scene_of(1)), std::vector<std::string>{ "area" });
  expect_refused("centroid_w", 1, "did you mean 'centroid_");
  expect_refused("gap", 1, "no such column");
  expect_refused("vesicle", 2, "no such column");
}

TEST(TradeoffObservables, OfSeveralVesiclesAreOfAllOrOfOne)
{
  const std::vector<std::string> named{ "gap", "velocity_z", "velocity_z[1]" };
  EXPECT_EQ(chosen_observables(named, scene_of(2)), named);
  expect_refused("velocity_z[2]", 2, "vesicles 0 to 1");
  expect_refused("velocity_z[-1]", 2, "vesicles 0 to 1");
  expect_refused("velocity_z[1", 2, "vesicles 0 to 1");
  expect_refused("velocity_z[0]", 1, "leave out the brackets");
}

TEST(TradeoffObservables, OfAllAreMeansAndLeastGaps)
{
  EXPECT_EQ(of_all("velocity_z", { 1, 2, 6 }, 3), 3);
  EXPECT_EQ(of_all("velocity_z", { 1, 2 }, 3), std::nullopt);
  EXPECT_EQ(of_all("gap", { 0.3, 0.2 }, 3), 0.2); // the third is far from all
  EXPECT_EQ(of_all("gap", {}, 3), std::nullopt);
}

}
