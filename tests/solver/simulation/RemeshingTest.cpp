// Meshes that are laid anew during a run.
#include "solver/Errors.h"
#include "solver/adaptation/SettledShape.h"
#include "solver/scene/SceneFile.h"
#include "solver/simulation/Simulation.h"
#include "solver/simulation/StartMesh.h"
#include "solver/simulation/SystemOfScene.h"
#include "solver/simulation/Trajectory.h"
#include "solver/surface/LoopBasis.h"
#include "solver/surface/LoopEnergy.h"

#include <gmock/gmock.h>

namespace vesicle
{
namespace
{

// Coarse and short.
Scene scene(std::vector<std::string> overrides = {})
{
  overrides.insert(overrides.begin(),
    { "vesicle.triangles=120", "accuracy.most_triangles=320", "time.end=0.05",
      "time.output_every=0.01" });
  return read_scene(VESICLE_SOURCE_DIR "/data/scenes/tadpole.toml", overrides);
}

double energy(Simulation& simulation, const State& state)
{
  return simulation.diagnose(state).bending_energy;
}

// The last state on the start mesh: the next step would start from another.
State before_remeshing(Simulation& simulation)
{
  State state = simulation.start();
  while (simulation.ready(state).remeshing.count == 0 && !simulation.finished(state))
    state = simulation.step(state);
  return state;
}

TEST(Remeshing, KeepsAreaAndVolumeAndBooksTheEnergy)
{
  Simulation simulation(scene(), make_start_mesh(scene()));
  const State before = before_remeshing(simulation), after = simulation.ready(before);
  ASSERT_EQ(after.remeshing.count, 1);
  EXPECT_GT(after.vesicles[0].triangles.rows(), before.vesicles[0].triangles.rows());
  EXPECT_LE(after.vesicles[0].triangles.rows(), 330);
  EXPECT_EQ(after.time, before.time);
  EXPECT_EQ(after.step, before.step);
  const double old = energy(simulation, before);
  const Diagnostics d = simulation.diagnose(after);
  EXPECT_LT(std::abs(d.area_drift), 1e-12);
  EXPECT_LT(std::abs(d.volume_drift), 1e-12);
  EXPECT_NEAR(d.bending_energy, old + d.remeshing_energy, 1e-9 * old);
  EXPECT_EQ(d.triangles, after.vesicles[0].triangles.rows());
  EXPECT_LT(loop_energy(simulation.mesh(after)).disagreement(),
    loop_energy(simulation.mesh(before)).disagreement());
}

// Steps are made from a state alone: from one that was kept they are the same, whatever mesh the
// simulation was on.
TEST(Remeshing, StepsFollowFromTheStateAlone)
{
  Simulation simulation(scene(), make_start_mesh(scene()));
  const State before = before_remeshing(simulation), ready = simulation.ready(before);
  const State again = simulation.ready(ready);
  EXPECT_EQ(again.vesicles[0].points, ready.vesicles[0].points);
  EXPECT_EQ(again.remeshing.count, 1);
  const State once = simulation.step(simulation.step(before));
  simulation.start(); // back on the start mesh
  Simulation other(scene(), make_start_mesh(scene()));
  const State twice = other.step(simulation.step(ready));
  EXPECT_EQ(once.vesicles[0].points, twice.vesicles[0].points);
  EXPECT_EQ(once.controller.next_step, twice.controller.next_step);
}

TEST(Remeshing, TheTrajectoryIsFoundAgainAcrossIt)
{
  const Scene s = scene();
  Simulation simulation(s, make_start_mesh(s)), thin(s, make_start_mesh(s));
  Trajectory all(simulation, simulation.start(), 100), forgetful(thin, thin.start(), 1);
  while (!all.finished())
    all.advance();
  while (!forgetful.finished())
    forgetful.advance();
  EXPECT_GT(all.last().remeshing.count, 0);
  for (const double time : { 0.004, 0.013, 0.037, 0.0495 })
  {
    const auto a = all.at(time), b = forgetful.at(time);
    ASSERT_TRUE(a.after && b.after);
    EXPECT_EQ(simulation.points_between(*a.before, *a.after, time),
      thin.points_between(*b.before, *b.after, time))
      << time;
  }
}

// What the energy changes by is the work done and what was booked, to a part in a thousand of what was
// dissipated meanwhile (steps of second order).
TEST(Remeshing, TheBalanceOfEnergyHolds)
{
  Simulation simulation(scene(), make_start_mesh(scene()));
  State state = simulation.start();
  Diagnostics before = simulation.diagnose(state);
  const double start = before.bending_energy;
  double work = 0, dissipated = 0;
  while (!simulation.finished(state))
  {
    const State ready = simulation.ready(state);
    before = simulation.diagnose(ready);
    state = simulation.step(ready);
    const Diagnostics after = simulation.diagnose(state);
    const double dt = after.time - before.time;
    work += dt / 2 * (before.power_in - before.dissipation + after.power_in - after.dissipation);
    dissipated += dt * after.dissipation;
  }
  const Diagnostics end = simulation.diagnose(state);
  EXPECT_NEAR(end.bending_energy - start, work + end.remeshing_energy, 1e-3 * dissipated);
}

// On a shape that its mesh holds, what bending does to the fluid changes by less than 10%.
TEST(Remeshing, BendingGoesOnAsBefore)
{
  Scene relaxing = scene({ "vesicle.triangles=320", "vesicle.reduced_volume=0.8" });
  relaxing.gravity.reset();
  relaxing.membrane.incompressible = false;
  const TriangleMesh start = make_start_mesh(relaxing);
  const SurfaceSpace space(
    SurfaceBasis::loop, start.triangles, static_cast<int>(start.points.rows()));
  // A state as it is on the way: relaxed on its own mesh.
  Simulation simulation(relaxing, start);
  State state = simulation.start();
  for (int step = 0; step < 12; ++step)
    state = simulation.step(state);
  const Surface old(space, state.vesicles[0].points);
  const MembraneTerms terms = membrane_terms(relaxing, space, simulation.scales());
  const Points velocity =
    Simulation(relaxing, simulation.mesh(state)).instant().vesicles[0].velocity;
  for (const int triangles : { 320, 640 })
  {
    const AdaptedMesh mesh = adapted_mesh(old, triangles);
    const SurfaceSpace fresh(
      SurfaceBasis::loop, mesh.mesh.triangles, static_cast<int>(mesh.places.size()));
    const SettledShape settled =
      settle_shape(fresh, membrane_terms(relaxing, fresh, simulation.scales()), mesh,
        { old, terms, old.area, old.volume });
    const Points carried =
      at_places(space.basis(), mesh.places, Points(space.collocation().fit(velocity)));
    const Points now =
      Simulation(relaxing, { settled.points, mesh.mesh.triangles }).instant().vesicles[0].velocity;
    EXPECT_LT((now - carried).norm(), 0.1 * carried.norm()) << triangles;
  }
}

TEST(Remeshing, ForeignStatesAreRefused)
{
  Simulation simulation(scene(), make_start_mesh(scene()));
  const State own = simulation.ready(before_remeshing(simulation));
  EXPECT_NO_THROW(simulation.require_own(own));
  State damaged = own;
  damaged.vesicles[0].triangles(0, 0) = 1'000'000;
  EXPECT_THROW(simulation.require_own(damaged), InputError);
  damaged = own;
  damaged.vesicles[0].triangles(0, 0) = damaged.vesicles[0].triangles(1, 0);
  EXPECT_THROW(simulation.require_own(damaged), InputError);
  const Scene fixed = scene({ "vesicle.reduced_volume=0.9" });
  Scene other = fixed;
  other.accuracy = Scene::preset(Scene::Preset::balanced);
  Simulation never(other, make_start_mesh(other));
  EXPECT_THROW(never.require_own(own), InputError);
}

std::string refusal(const std::vector<std::string>& overrides)
{
  try
  {
    scene(overrides);
    return "";
  }
  catch (const InputError& error)
  {
    return error.what();
  }
}

TEST(Remeshing, KeysThatDoNothingAreRefused)
{
  EXPECT_THAT(refusal({ "accuracy.preset=fast" }), testing::HasSubstr("basis = \"loop\""));
  EXPECT_THAT(
    refusal({ "accuracy.mesh_motion=material" }), testing::HasSubstr("mesh_motion = \"adaptive\""));
  EXPECT_THAT(refusal({ "accuracy.least_triangles=640" }), testing::HasSubstr("least_triangles"));
}

}
}
