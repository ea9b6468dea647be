// Runs of several vesicles: what they share with a vesicle alone, fields and diagnostics of each,
// restarts, what is refused.

#include "solver/Errors.h"
#include "solver/scene/SceneFile.h"
#include "solver/simulation/Simulation.h"
#include "solver/simulation/StartOverlap.h"
#include "solver/simulation/SystemOfScene.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

using namespace vesicle;

namespace
{

const std::string rising = R"(
[[vesicle]]
shape = "prolate"
reduced_volume = 0.9
triangles = 80
center = [0, 0, 0]
[[vesicle]]
shape = "sphere"
triangles = 120
radius = 0.7
center = [{}, 0, 0]
[vesicle.membrane]
bending_rigidity = 3
[vesicle.gravity]
bond_number = -1
[membrane]
bending_rigidity = 2
[gravity]
bond_number = 4
[time]
end = 1
output_every = 0.1
)";

Scene scene_at(const std::string& distance)
{
  std::string text = rising;
  return parse_scene(text.replace(text.find("{}"), 2, distance), "s.toml");
}

Simulation simulation_of(const Scene& scene)
{
  return Simulation(scene, make_start_meshes(scene));
}

bool same(const State& a, const State& b)
{
  bool all = a.time == b.time && a.controller.next_step == b.controller.next_step;
  for (std::size_t v = 0; v < a.vesicles.size(); ++v)
    all = all && a.vesicles[v].points == b.vesicles[v].points &&
      a.vesicles[v].velocity == b.vesicles[v].velocity &&
      a.vesicles[v].tension == b.vesicles[v].tension;
  return all;
}

}

// Far apart each moves as it would alone, but for what the other's force does there: a force of
// 4π/3 Bo at a distance d makes velocities of about that over 4π d.
TEST(SeveralVesiclesSimulation, FarApartEachMovesAsAlone)
{
  const Scene scene = scene_at("1e4");
  Simulation both = simulation_of(scene);
  const std::vector<Diagnostics> together = both.diagnose_all(both.instant());
  ASSERT_EQ(together.size(), 2u);
  for (std::size_t v = 0; v < 2; ++v)
  {
    const Scene own = scene.alone(v);
    Simulation alone(own, make_start_mesh(own));
    const Diagnostics d = alone.diagnose(alone.instant());
    // Coordinates are rounded to 1e-12.
    EXPECT_NEAR(together[v].area / d.area, 1, 1e-10) << v;
    EXPECT_NEAR(together[v].volume / d.volume, 1, 1e-10) << v;
    EXPECT_NEAR(together[v].bending_energy / d.bending_energy, 1, 1e-8) << v;
    EXPECT_NEAR(together[v].energy_over_8pi / d.energy_over_8pi, 1, 1e-8) << v;
  }
  const Scene own = scene.alone(0);
  Simulation alone(own, make_start_mesh(own));
  EXPECT_NEAR(together[0].velocity[2] / alone.diagnose(alone.instant()).velocity[2], 1, 1e-4);
  // The second one's Bond number is in units of the first one's r0 and EB: a sphere, which an
  // inextensible membrane makes rigid, falls by 2/9 Bo a² EB/(μ r0²).
  EXPECT_NEAR(together[1].velocity[2] / (-2. / 9 * std::pow(0.7, 2) * 2), 1, 1e-3);
}

TEST(SeveralVesiclesSimulation, FieldsAndPointsStandOneAfterTheOther)
{
  const Scene scene = scene_at("3");
  Simulation simulation = simulation_of(scene);
  const State state = simulation.start();
  const auto n = state.vesicles[0].points.rows(), m = state.vesicles[1].points.rows();
  const TriangleMesh mesh = simulation.mesh(state);
  EXPECT_EQ(mesh.points.rows(), n + m);
  EXPECT_EQ(mesh.triangles.rows(), 200);
  EXPECT_EQ(mesh.triangles.bottomRows(120).minCoeff(), n);
  EXPECT_EQ(mesh.points.bottomRows(m), simulation.start_mesh().points.bottomRows(m));
  const std::vector<int> ids = simulation.vesicle_ids(state);
  ASSERT_EQ(ids.size(), static_cast<std::size_t>(n + m));
  EXPECT_EQ(ids[n - 1], 0);
  EXPECT_EQ(ids[n], 1);
  for (const auto& [name, values] : simulation.fields(state))
    EXPECT_EQ(values.rows(), n + m) << name;
}

// A vesicle without bending has a bending force of 0, as its grid has other vesicles' too.
TEST(SeveralVesiclesSimulation, WhatOneDoesNotHaveIsZero)
{
  Scene scene = scene_at("3");
  scene.companions[0].membrane.bending_rigidity.reset();
  Simulation simulation = simulation_of(scene);
  const State state = simulation.start();
  const auto m = state.vesicles[1].points.rows();
  const Eigen::MatrixXd force = simulation.fields(state).at("Bending_Force");
  EXPECT_GT(force.topRows(force.rows() - m).norm(), 0);
  EXPECT_EQ(force.bottomRows(m).norm(), 0);
}

Scene spheres(double distance, const std::string& more = "")
{
  return parse_scene(
    fmt::format("[[vesicle]]\nshape = \"sphere\"\ntriangles = 320\n[[vesicle]]\nshape = "
                "\"sphere\"\ntriangles = 320\nradius = 0.5\ncenter = [{:.6f}, 0, 0]\n"
                "[membrane]\nbending_rigidity = 2\n[time]\nend = 1\noutput_every = 1\n{}",
      distance, more),
    "s.toml");
}

// Vertices that face each other are rarely on the line of centres: an edge's square times the
// curvatures, .02, is what they may be off.
TEST(SeveralVesiclesSimulation, TellHowFarTheyAreApart)
{
  Simulation simulation = simulation_of(spheres(1.8));
  const std::vector<Diagnostics> near = simulation.diagnose_all(simulation.instant());
  EXPECT_NEAR(*near[0].gap, 0.3, 0.02);
  EXPECT_EQ(near[0].gap, near[1].gap);
  Simulation apart = simulation_of(spheres(2.6));
  EXPECT_FALSE(apart.diagnose_all(apart.instant())[0].gap);
}

TEST(SeveralVesiclesSimulation, RepelEachOtherWhereTheSceneSaysSo)
{
  const auto speed = [](const std::string& more)
  {
    Simulation simulation = simulation_of(spheres(1.8, more));
    return simulation.diagnose_all(simulation.instant())[1].velocity[0];
  };
  // What the layers of 320 triangles are off by (docs/numerics.md).
  constexpr double at_rest = 1e-4;
  EXPECT_NEAR(speed(""), 0, at_rest);
  const double once = speed("[interaction]\nrepulsion = 0.5\nrange = 0.5\n");
  EXPECT_GT(once, 0.01);
  EXPECT_NEAR(speed("[interaction]\nrepulsion = 1.0\nrange = 0.5\n") / once, 2, 1e-3);
  EXPECT_NEAR(speed("[interaction]\nrepulsion = 1.0\nrange = 0.25\n"), 0, at_rest);
  EXPECT_THROW(
    parse_scene("[vesicle]\nshape = \"sphere\"\n[interaction]\nrepulsion = 1\nrange = 1\n"
                "[time]\nend = 1\noutput_every = 1\n",
      "s.toml"),
    InputError);
}

TEST(SeveralVesiclesSimulation, OnTheSameTrianglesShareWhatTheyFix)
{
  const Scene scene = spheres(3);
  std::vector<VesicleMesh> meshes;
  for (const StartMesh& start : make_start_meshes(scene))
    meshes.push_back({ start.mesh.triangles, static_cast<int>(start.mesh.points.rows()), {} });
  const System system = system_of(scene, {}, meshes);
  EXPECT_EQ(system.vesicles[0].space, system.vesicles[1].space);
  EXPECT_EQ(system.vesicles[0].layer, system.vesicles[1].layer);
  EXPECT_NE(system.vesicles[0].terms[0], system.vesicles[1].terms[0]);
}

TEST(SeveralVesiclesSimulation, GoOnFromAStateBitForBit)
{
  const Scene scene = scene_at("3");
  Simulation simulation = simulation_of(scene);
  State state = simulation.start();
  for (int i = 0; i < 2; ++i)
    state = simulation.step(state);
  Simulation other = simulation_of(scene);
  other.require_own(state);
  EXPECT_TRUE(same(simulation.step(state), other.step(state)));
}

TEST(SeveralVesiclesSimulation, StatesOfOthersAreRefused)
{
  const Scene scene = scene_at("3");
  Simulation simulation = simulation_of(scene);
  State state = simulation.start();
  std::swap(state.vesicles[0], state.vesicles[1]);
  EXPECT_THROW(simulation.require_own(state), InputError);
  state.vesicles.pop_back();
  state.preconditioner.points.pop_back();
  EXPECT_THROW(simulation.require_own(state), InputError);
}

TEST(SeveralVesiclesSimulation, WhatOverlapsOrIsForOneIsRefused)
{
  const auto error_of = [](const Scene& scene)
  {
    try
    {
      simulation_of(scene);
    }
    catch (const InputError& error)
    {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_EQ(error_of(scene_at("1.2")).find("vesicles 0 and 1 overlap near ("), 0u);
  Scene nested = scene_at("0");
  nested.companions[0].vesicle.radius = 0.2;
  EXPECT_EQ(error_of(nested).find("vesicles 0 and 1 are one inside of the other near ("), 0u);
  Scene flat = scene_at("3");
  flat.accuracy = Scene::preset(Scene::Preset::fast);
  EXPECT_EQ(error_of(flat).find("several vesicles take Loop's surface"), 0u);
  Scene one = scene_at("3");
  EXPECT_THROW(Simulation(one, make_start_mesh(one)), InputError);
}

TEST(StartOverlap, TellsInsideFromOutside)
{
  Scene scene;
  scene.vesicle.shape.triangles = 80;
  const TriangleMesh sphere = make_start_mesh(scene);
  EXPECT_TRUE(encloses(sphere, { 0.3, 0.5, -0.4 }));
  EXPECT_FALSE(encloses(sphere, { 0.9, 0.5, -0.4 }));
}
