// What a state says of its own errors, beside what they are.

#include "solver/simulation/Simulation.h"
#include "solver/simulation/StartMesh.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vesicle
{
namespace
{

Scene rising_prolate(Scene::Preset preset, int triangles)
{
  Scene scene;
  scene.accuracy = Scene::preset(preset);
  scene.vesicle.shape.kind = ShapeRequest::Kind::prolate;
  scene.vesicle.shape.reduced_volume = 0.8;
  scene.vesicle.shape.triangles = triangles;
  scene.membrane.bending_rigidity = 1;
  scene.gravity = Scene::Gravity{ 10., 0, 0 };
  scene.time.end = 1;
  return scene;
}

struct AtTheStart
{
  ErrorEstimate errors;
  Diagnostics diagnostics;
};

AtTheStart start_of(const Scene& scene)
{
  Simulation simulation(scene, make_start_mesh(scene));
  const State state = simulation.start();
  return { simulation.error_estimate(state), simulation.diagnose(state) };
}

}

// Errors of Loop's surface are of first order in N around extraordinary vertices, of second elsewhere.
TEST(ErrorEstimate, FallsAsTheTrianglesGrow)
{
  const auto coarse = start_of(rising_prolate(Scene::Preset::balanced, 80)).errors,
             fine = start_of(rising_prolate(Scene::Preset::balanced, 320)).errors;
  EXPECT_GT(*coarse.energy, 4 * *fine.energy);
  EXPECT_GT(*coarse.energy_coarse, 4 * *fine.energy_coarse);
  EXPECT_EQ(fine.space(), std::max(*fine.energy, fine.layer));
  EXPECT_LT(coarse.time, 1e-9); // nothing was projected yet
}

// The energy of flat triangles is too low; how much so their vertices know.
TEST(ErrorEstimate, KnowsTheBiasOfFlatTriangles)
{
  const double exact =
    start_of(rising_prolate(Scene::Preset::balanced, 1280)).diagnostics.energy_over_8pi;
  for (const int triangles : { 320, 1280 })
  {
    const auto flat = start_of(rising_prolate(Scene::Preset::fast, triangles));
    const double error = std::abs(flat.diagnostics.energy_over_8pi / exact - 1);
    EXPECT_NEAR(*flat.errors.energy / error, 1, 1. / 3) << triangles; // of the meshes, too
    EXPECT_FALSE(flat.errors.energy_coarse);
  }
}

// Area and volume are restored after each step: what was taken out tells of the step.
TEST(ErrorEstimate, SeesWhatTheProjectionHides)
{
  double before = 0;
  for (const double step : { 0.02, 0.01, 0.005 })
  {
    Scene scene = rising_prolate(Scene::Preset::balanced, 80);
    scene.time.step = step;
    Simulation simulation(scene, make_start_mesh(scene));
    State state = simulation.start();
    while (state.time < 0.06 - 1e-9)
      state = simulation.step(state);
    const double time = simulation.error_estimate(state).time;
    EXPECT_LT(std::abs(simulation.diagnose(state).area_drift), 1e-9);
    EXPECT_GT(time, 1e-9);
    if (before > 0)
    {
      EXPECT_GT(before / time, 2.5); // a second order's 4, as steps become short
    }
    before = time;
  }
}

TEST(ErrorEstimate, IsThatOfTheLayerWithoutBending)
{
  Scene scene = rising_prolate(Scene::Preset::balanced, 80);
  scene.membrane.bending_rigidity.reset();
  scene.gravity = Scene::Gravity{ std::nullopt, 1., 1. };
  const auto coarse = start_of(scene).errors;
  EXPECT_FALSE(coarse.energy);
  EXPECT_EQ(coarse.space(), coarse.layer);
  scene.vesicle.shape.triangles = 320;
  EXPECT_GT(coarse.layer, 2 * start_of(scene).errors.layer);
}

}
