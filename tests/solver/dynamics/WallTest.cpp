// Vesicles beside a wall: against rigid spheres and the far field, and what must not change.

#include "solver/Errors.h"
#include "solver/dynamics/Evolution.h"
#include "solver/dynamics/StepFailure.h"
#include "solver/dynamics/WallGap.h"
#include "solver/flow/Shear.h"
#include "solver/flow/Uniform.h"
#include "solver/membrane/Buoyancy.h"
#include "solver/membrane/HelfrichBending.h"
#include "solver/simulation/History.h"
#include "solver/simulation/StartMesh.h"
#include "tests/solver/dynamics/LayerMethods.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <cmath>

namespace vesicle
{
namespace
{

const Wall ground{ Vector3::Zero(), Vector3::UnitZ() };

System alone(const TriangleMesh& mesh, double viscosity_ratio = 1)
{
  System system;
  system.vesicles.push_back(
    make_vesicle(SurfaceBasis::loop, mesh.triangles, static_cast<int>(mesh.points.rows()), 3));
  system.vesicles[0].viscosity_ratio = viscosity_ratio;
  return system;
}

Evolution evolution_of(System system, std::optional<double> fixed_step = {})
{
  return { std::move(system), StepperSettings{}, OutputSchedule(0, 100.), 1, fixed_step };
}

Points lifted(const TriangleMesh& mesh, double height)
{
  return mesh.points.rowwise() + Eigen::RowVector3d(0, 0, height);
}

State steps(Evolution& evolution, State state, int count)
{
  for (int i = 0; i < count; ++i)
    state = evolution.step(state);
  return state;
}

// Along the normal nothing moves within an inextensible sphere, whatever is inside (H. Brenner, Chem. Eng.
// Sci. 16 (1961) 242).
TEST(Walls, AnInextensibleSphereFallsAsARigidOneWhateverIsInside)
{
  const TriangleMesh mesh = test::smooth_sphere(1280);
  for (const double ratio : { 1., 5. })
    for (const auto& [height, drag] : { std::pair(1.5430806, 3.0360645), std::pair(2., 2.1255356),
           std::pair(3., 1.5692054), std::pair(5., 1.2850866) })
    {
      System system = alone(mesh, ratio);
      Vesicle& sphere = system.vesicles[0];
      sphere.terms.push_back(make_buoyancy(*sphere.space, -1));
      sphere.incompressibility = make_incompressibility(*sphere.space);
      system.wall = ground;
      Evolution evolution = evolution_of(std::move(system));
      const State state = evolution.instant({ lifted(mesh, height) });
      const auto shape = evolution.stepper().shape(state);
      const Vector3 speed =
        shape->vesicles[0].surface->mean_velocity(flat(state.vesicles[0].velocity));
      EXPECT_NEAR(-speed.z() * drag / (2. / 9), 1, 3e-5) << height << ", " << ratio;
    }
}

TriangleMesh body(int triangles)
{
  return test::mapped(test::smooth_sphere(triangles),
    [](const Vector3& d) -> Vector3 {
      return { 1.3 * d.x() + 0.3 * d.z(), 0.9 * d.y(), 0.9 * d.z() };
    });
}

System sheared_over_wall(const TriangleMesh& mesh, double viscosity_ratio)
{
  System system = alone(mesh, viscosity_ratio);
  Vesicle& vesicle = system.vesicles[0];
  vesicle.terms.push_back(make_bending(*vesicle.space, 0));
  vesicle.incompressibility = make_incompressibility(*vesicle.space);
  system.flow = std::make_shared<Shear>(2);
  system.wall = ground;
  return system;
}

// What holds a vesicle in shape makes a stresslet Σ, whose images lift it by −9 Σ_zz/64πh² far from the
// wall; the next terms go with 1/h⁴.
TEST(Walls, LiftAVesicleByItsStressletFarAway)
{
  const TriangleMesh mesh = body(320);
  double error[2];
  for (int level = 0; level < 2; ++level)
  {
    const double height = level == 0 ? 6 : 12;
    Scene scene;
    scene.flow = std::make_shared<Shear>(1);
    scene.wall = ground;
    scene.time.end = 1;
    Simulation simulation(scene, { lifted(mesh, height), mesh.triangles });
    const Diagnostics d = simulation.diagnose(simulation.instant());
    const double far = -9 * d.stresslet[5] / (64 * M_PI * d.centroid[2] * d.centroid[2]);
    error[level] = std::abs(*d.lift_speed / far - 1);
    EXPECT_GT(*d.lift_speed, 0);
  }
  EXPECT_LT(error[1], 0.02);
  EXPECT_LT(error[1], error[0] / 2);
}

TEST(Walls, MethodsOfTheLayerAgree)
{
  const TriangleMesh mesh = body(80);
  const System system = sheared_over_wall(mesh, 3);
  test::expect_methods_agree(system, SystemShape(system, { lifted(mesh, 1) }));
}

TEST(Walls, NoBitDependsOnThreadsOrARestart)
{
  const TriangleMesh mesh = body(80);
  std::vector<State> states;
  for (const int threads : { 1, 3 })
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    Evolution evolution = evolution_of(sheared_over_wall(mesh, 3));
    const State saved = steps(evolution, evolution.start({ lifted(mesh, 1) }), 2);
    states.push_back(steps(evolution, saved, 2));
    Evolution other = evolution_of(sheared_over_wall(mesh, 3)); // nothing cached
    EXPECT_EQ(steps(other, saved, 2).vesicles[0].points, states.back().vesicles[0].points);
  }
  EXPECT_EQ(states[0].vesicles[0].points, states[1].vesicles[0].points);
}

/// A bent shape at rest a fifth of an edge over the wall.
Scene resting(double end, double step)
{
  Scene scene;
  scene.membrane.bending_rigidity = 1;
  scene.wall = Wall{ { 0, 0, -1 }, Vector3::UnitZ() };
  scene.time.end = scene.time.output_every = end;
  if (step > 0)
    scene.time.step = step;
  return scene;
}

TriangleMesh resting_body()
{
  TriangleMesh mesh = body(320);
  mesh.points.col(2).array() -= mesh.points.col(2).minCoeff() + 0.95;
  return mesh;
}

// The work by the trapezoidal rule, as EnergyLaw has it without a wall.
TEST(Walls, LeaveTheEnergyLaw)
{
  const History run = run_to_end(std::make_shared<Simulation>(resting(5e-6, 1e-6), resting_body()));
  double work = 0;
  for (std::size_t i = 1; i < run.rows.size(); ++i)
  {
    const Diagnostics &a = run.rows[i - 1], &b = run.rows[i];
    work += (b.time - a.time) * (a.power_in - a.dissipation + b.power_in - b.dissipation) / 2;
  }
  EXPECT_LT(work, 0);
  // 1.7e-5 was measured, with a wall and without.
  EXPECT_NEAR((run.rows.back().bending_energy - run.rows.front().bending_energy) / work, 1, 9e-5);
}

TEST(Walls, DescendsInFewStepsBesideThem)
{
  const History run = run_to_end(std::make_shared<Simulation>(resting(0.5, 0), resting_body()));
  EXPECT_LE(run.rows.size(), 60);
  for (std::size_t i = 1; i < run.rows.size(); ++i)
    EXPECT_LE(run.rows[i].bending_energy, (1 + 1e-6) * run.rows[i - 1].bending_energy) << i;
}

// The surface's lowest point, between the vertices: a sphere's is n away from its centre.
TEST(Walls, TheirGapIsTheSurfaces)
{
  double error[2] = {};
  for (int level = 0; level < 2; ++level)
  {
    const TriangleMesh mesh = test::smooth_sphere(level == 0 ? 320 : 1280);
    const System system = alone(mesh);
    const Surface surface(*system.vesicles[0].space, mesh.points);
    for (const Vector3& n : { Vector3(0, 0, 1), Vector3(0.36, 0.48, 0.8), Vector3(-0.6, 0, -0.8) })
    {
      const Wall wall{ Vector3(-1.3 * n), n };
      const WallGap gap = wall_gap(wall, { system.vesicles[0].layer.get(), &surface });
      error[level] = std::max(error[level], std::abs(gap.distance - 0.3));
      EXPECT_LT((gap.place + n).norm(), 0.05);
      EXPECT_NEAR(wall.height(gap.place), gap.distance, 1e-12);
    }
  }
  EXPECT_LT(error[0], 3e-4); // a vertex may be 1.6e-2 higher
  EXPECT_LT(error[1], error[0] / 3);
}

/// A drop that falls onto the wall.
System falling(const TriangleMesh& mesh)
{
  System system = alone(mesh);
  system.vesicles[0].terms.push_back(make_buoyancy(*system.vesicles[0].space, -20));
  system.wall = ground;
  return system;
}

// Below a tenth of an edge the run ends; the steps before have become shorter.
TEST(Walls, ContactStopsWithThePlaceAndTheGap)
{
  const TriangleMesh mesh = test::smooth_sphere(80);
  Evolution evolution = evolution_of(falling(mesh));
  State state = evolution.start({ lifted(mesh, 1.3) });
  try
  {
    state = steps(evolution, state, 200);
    FAIL() << state.time;
  }
  catch (const StepFailure& failure)
  {
    const std::string told = failure.what();
    EXPECT_NE(told.find("t = "), std::string::npos) << told;
    EXPECT_NE(told.find("the vesicle is 0.0"), std::string::npos) << told;
    EXPECT_NE(told.find("from the wall near ("), std::string::npos) << told;
    EXPECT_NE(told.find("more triangles"), std::string::npos) << told;
  }
}

TEST(Walls, AFixedStepThroughThemIsRefused)
{
  const TriangleMesh mesh = test::smooth_sphere(80);
  Evolution evolution = evolution_of(falling(mesh), 0.05);
  State state = evolution.start({ lifted(mesh, 1.6) });
  EXPECT_THROW(steps(evolution, state, 60), StepFailure);
}

std::string refusal(const Scene& scene, const TriangleMesh& mesh)
{
  try
  {
    Simulation(scene, mesh);
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return {};
}

TEST(Walls, RefuseWhatDoesNotGoWithThem)
{
  const TriangleMesh mesh = test::smooth_sphere(80);
  Scene scene;
  scene.time.end = 1;
  scene.wall = Wall{ { 0, 0, -2 }, Vector3::UnitZ() };
  EXPECT_EQ(refusal(scene, mesh), "");

  Scene crossing = scene;
  crossing.wall->point.z() = -0.9;
  EXPECT_NE(refusal(crossing, mesh).find("crosses the wall"), std::string::npos);
  Scene behind = scene;
  behind.wall->normal *= -1;
  EXPECT_NE(refusal(behind, mesh).find("behind"), std::string::npos);
  Scene flat = scene;
  flat.accuracy = Scene::preset(Scene::Preset::fast);
  EXPECT_NE(refusal(flat, mesh).find("Loop's surface"), std::string::npos);

  Scene sheared = scene;
  sheared.flow = std::make_shared<Shear>(1);
  EXPECT_NE(refusal(sheared, mesh).find("(-2, 0, 0)"), std::string::npos) << refusal(sheared, mesh);
  sheared.wall->point.z() = 0;
  EXPECT_EQ(refusal(sheared, { lifted(mesh, 2), mesh.triangles }), "");
  Scene streaming = scene;
  streaming.flow = std::make_shared<Uniform>(Vector3(1, 0, 0));
  EXPECT_NE(refusal(streaming, mesh).find("uniform"), std::string::npos);
}

// Two vesicles feel the wall, and its images of each other: far apart along it each is lifted as alone.
TEST(Walls, SeveralVesiclesHaveTheirImages)
{
  const TriangleMesh mesh = body(80);
  const auto lift = [&](int count, double apart)
  {
    System system = sheared_over_wall(mesh, 1);
    std::vector<Points> points{ lifted(mesh, 1.5) };
    if (count > 1)
    {
      system.vesicles.push_back(make_vesicle_like(system.vesicles[0]));
      Vesicle& other = system.vesicles[1];
      other.terms.push_back(make_bending(*other.space, 0));
      other.incompressibility = make_incompressibility(*other.space);
      points.emplace_back(points[0].rowwise() + Eigen::RowVector3d(0, apart, 0));
    }
    Evolution evolution = evolution_of(std::move(system));
    const State state = evolution.instant(points);
    return evolution.stepper()
      .shape(state)
      ->vesicles[0]
      .surface->mean_velocity(flat(state.vesicles[0].velocity))
      .z();
  };
  const double single = lift(1, 0), far = lift(2, 40), near = lift(2, 2.5);
  EXPECT_NEAR(far / single, 1, 1e-3);
  EXPECT_GT(std::abs(near / single - 1), 1e-2);
}

}
}
