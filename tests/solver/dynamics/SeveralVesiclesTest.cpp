// Vesicles that feel each other through the fluid: against closed forms, and what no order of theirs
// and no number of threads may change.

#include "solver/Errors.h"
#include "solver/dynamics/Evolution.h"
#include "solver/dynamics/StepFailure.h"
#include "solver/flow/Shear.h"
#include "solver/membrane/Buoyancy.h"
#include "solver/membrane/HelfrichBending.h"
#include "solver/simulation/StartMesh.h"
#include "tests/solver/dynamics/LayerMethods.h"
#include "tests/solver/dynamics/SmallestGap.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace vesicle
{
namespace
{

/// Vesicles on one mesh, each of them furnished.
System system_of(
  const TriangleMesh& mesh, std::size_t count, const std::function<void(Vesicle&)>& furnish)
{
  System system;
  for (std::size_t v = 0; v < count; ++v)
  {
    system.vesicles.push_back(v == 0
        ? make_vesicle(SurfaceBasis::loop, mesh.triangles, static_cast<int>(mesh.points.rows()), 3)
        : make_vesicle_like(system.vesicles[0]));
    furnish(system.vesicles.back());
  }
  return system;
}

/// The load Bo z n.
void load_only(Vesicle& vesicle)
{
  vesicle.terms.push_back(make_buoyancy(*vesicle.space, 1));
}

void loaded_and_inextensible(Vesicle& vesicle)
{
  load_only(vesicle);
  vesicle.incompressibility = make_incompressibility(*vesicle.space);
}

void bending_and_inextensible(Vesicle& vesicle)
{
  vesicle.terms.push_back(make_bending(*vesicle.space, 0));
  vesicle.incompressibility = make_incompressibility(*vesicle.space);
}

void inextensible(Vesicle& vesicle)
{
  vesicle.incompressibility = make_incompressibility(*vesicle.space);
}

std::vector<Points> along_z(const TriangleMesh& mesh, std::size_t count, double distance)
{
  std::vector<Points> points;
  for (std::size_t v = 0; v < count; ++v)
    points.emplace_back(
      mesh.points.rowwise() + Eigen::RowVector3d(0, 0, static_cast<double>(v) * distance));
  return points;
}

Evolution evolution_of(System system, std::optional<double> fixed_step = {})
{
  StepperSettings settings;
  return { std::move(system), settings, OutputSchedule(0, 100.), 1, fixed_step };
}

/// Speeds along z of the centroids at the first instant.
std::vector<double> rise(System system, const std::vector<Points>& points)
{
  Evolution evolution = evolution_of(std::move(system));
  const State state = evolution.instant(points);
  const auto shape = evolution.stepper().shape(state);
  std::vector<double> speeds;
  for (std::size_t v = 0; v < points.size(); ++v)
    speeds.push_back(
      shape->vesicles[v].surface->mean_velocity(flat(state.vesicles[v].velocity)).z());
  return speeds;
}

// Blobs without a membrane, one viscosity: 1 + 5/(4d) − 1/(2d³) times as fast as one alone.
TEST(SeveralVesicles, TwoBlobsHelpEachOtherAsTheClosedFormSays)
{
  const TriangleMesh mesh = test::smooth_sphere(1280);
  const double alone = rise(system_of(mesh, 1, load_only), { mesh.points })[0];
  for (const double gap : { 0.01, 0.1, 1. })
  {
    const double d = 2 + gap;
    for (const double speed : rise(system_of(mesh, 2, load_only), along_z(mesh, 2, d)))
      EXPECT_NEAR(speed / alone, 1 + 5 / (4 * d) - 1 / (2 * d * d * d), 1e-4) << gap;
  }
}

// Along their line of centres, with the drag of rigid spheres (Stimson & Jeffery's): nothing moves
// within them, so that the fluid inside, whose double layer is near the other sphere, doesn't tell.
TEST(SeveralVesicles, InextensibleSpheresRiseAsRigidOnesWhateverIsInside)
{
  const TriangleMesh mesh = test::smooth_sphere(1280);
  for (const double ratio : { 1., 5. })
    for (const auto& [d, drag] :
      { std::pair(2.1, 0.6509001445), std::pair(2.5, 0.6729155138), std::pair(4., 0.7422582851) })
    {
      const auto furnish = [&](Vesicle& vesicle)
      {
        loaded_and_inextensible(vesicle);
        vesicle.viscosity_ratio = ratio;
      };
      for (const double speed : rise(system_of(mesh, 2, furnish), along_z(mesh, 2, d)))
        EXPECT_NEAR(speed * drag / (2. / 9), 1, 1e-3) << d << ", " << ratio;
    }
}

TriangleMesh body(int triangles)
{
  return test::mapped(test::smooth_sphere(triangles),
    [](const Vector3& d) -> Vector3 {
      return { 1.3 * d.x() + 0.1 * d.z(), 0.9 * d.y(), 0.9 * d.z() };
    });
}

std::vector<Points> side_by_side(const TriangleMesh& mesh)
{
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.5, Vector3(1, 1, 0).normalized()).matrix();
  return { mesh.points,
    Points((mesh.points * turn.transpose()).rowwise() + Eigen::RowVector3d(0.4, 0.2, 1.95)) };
}

System sheared(const TriangleMesh& mesh)
{
  System system = system_of(mesh, 2, bending_and_inextensible);
  system.flow = std::make_shared<Shear>(2);
  return system;
}

State steps(Evolution& evolution, State state, int count)
{
  for (int i = 0; i < count; ++i)
    state = evolution.step(state);
  return state;
}

TEST(SeveralVesicles, TheirOrderDoesNotMatter)
{
  const TriangleMesh mesh = body(80);
  std::vector<Points> points = side_by_side(mesh);
  std::vector<State> states;
  for (int swapped = 0; swapped < 2; ++swapped)
  {
    Evolution evolution = evolution_of(sheared(mesh), 0.005);
    states.push_back(steps(evolution, evolution.start(points), 4));
    std::swap(points[0], points[1]);
  }
  for (std::size_t v = 0; v < 2; ++v)
    EXPECT_LT((states[0].vesicles[v].points - states[1].vesicles[1 - v].points).norm(), 1e-8) << v;
}

TEST(SeveralVesicles, NoBitDependsOnTheNumberOfThreads)
{
  const TriangleMesh mesh = body(80);
  std::vector<State> states;
  for (const int threads : { 1, 3 })
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    System system = sheared(mesh);
    system.repulsion = Repulsion{ .strength = 0.5, .range = 0.3 };
    Evolution evolution = evolution_of(std::move(system), 0.005);
    states.push_back(steps(evolution, evolution.start(side_by_side(mesh)), 3));
  }
  for (std::size_t v = 0; v < 2; ++v)
    EXPECT_EQ(states[0].vesicles[v].points, states[1].vesicles[v].points);
}

TEST(SeveralVesicles, ARestoredStateGoesOnBitForBit)
{
  const TriangleMesh mesh = body(80);
  Evolution evolution = evolution_of(sheared(mesh));
  const State saved = steps(evolution, evolution.start(side_by_side(mesh)), 3),
              state = steps(evolution, saved, 3);
  Evolution other = evolution_of(sheared(mesh)); // nothing cached
  const State again = steps(other, saved, 3);
  for (std::size_t v = 0; v < 2; ++v)
  {
    EXPECT_EQ(again.vesicles[v].points, state.vesicles[v].points);
    EXPECT_EQ(again.vesicles[v].tension, state.vesicles[v].tension);
  }
  EXPECT_EQ(again.controller.next_step, state.controller.next_step);
}

TEST(SeveralVesicles, MethodsOfTheLayerAgree)
{
  const TriangleMesh mesh = body(80);
  System system = sheared(mesh);
  system.vesicles[1].viscosity_ratio = 3;
  test::expect_methods_agree(system, SystemShape(system, side_by_side(mesh)));
}

TEST(SeveralVesicles, CrossingAtTheStartIsRefused)
{
  const TriangleMesh mesh = body(80);
  Evolution evolution = evolution_of(sheared(mesh));
  try
  {
    evolution.start({ mesh.points, Points(mesh.points.rowwise() + Eigen::RowVector3d(0, 0, 1.6)) });
    FAIL();
  }
  catch (const NumericalError& error)
  {
    EXPECT_NE(std::string(error.what()).find("t = 0: vesicles"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("cross near"), std::string::npos) << error.what();
  }
}

/// Drops that are pressed onto each other by opposite loads.
System colliding(const TriangleMesh& mesh)
{
  System system = system_of(mesh, 2, [](Vesicle&) {});
  system.vesicles[0].terms.push_back(make_buoyancy(*system.vesicles[0].space, 20));
  system.vesicles[1].terms.push_back(make_buoyancy(*system.vesicles[1].space, -20));
  return system;
}

// A fixed step would take them through each other: it is refused with time, place and numbers.
TEST(SeveralVesicles, AStepThroughAnotherVesicleIsRefused)
{
  const TriangleMesh mesh = test::smooth_sphere(80);
  Evolution evolution = evolution_of(colliding(mesh), 0.02);
  State state = evolution.start(along_z(mesh, 2, 2.3));
  try
  {
    state = steps(evolution, state, 60);
    FAIL() << state.time;
  }
  catch (const StepFailure& failure)
  {
    EXPECT_NE(std::string(failure.what()).find("t = "), std::string::npos) << failure.what();
    EXPECT_NE(std::string(failure.what()).find("vesicles"), std::string::npos) << failure.what();
  }
}

// No step would take more than a quarter of what is between the two poles.
TEST(SeveralVesicles, StepsAreBoundedByTheGap)
{
  const TriangleMesh mesh = test::smooth_sphere(80);
  Evolution evolution = evolution_of(colliding(mesh));
  Eigen::Index top, bottom;
  mesh.points.col(2).maxCoeff(&top);
  mesh.points.col(2).minCoeff(&bottom);
  for (const double gap : { 0.05, 0.2 })
  {
    const State state = evolution.instant(along_z(mesh, 2, 2 + gap));
    const double left = state.vesicles[1].points(bottom, 2) - state.vesicles[0].points(top, 2),
                 closing =
                   state.vesicles[0].velocity(top, 2) - state.vesicles[1].velocity(bottom, 2);
    EXPECT_GT(closing, 0);
    EXPECT_LT(evolution.stepper().longest_step(state), 1.02 * left / (4 * closing)) << gap;
  }
}

/// v = .95, tank-treading steadily in the shear u∞ = z e_x, centred.
Points tank_treading(const TriangleMesh& start)
{
  System system = system_of(start, 1, inextensible);
  system.flow = std::make_shared<Shear>(1);
  Evolution evolution = evolution_of(std::move(system));
  State state = evolution.start({ start.points });
  while (state.time < 12)
    state = evolution.step(state);
  const Vector3 center = evolution.stepper().shape(state)->vesicles[0].surface->center;
  return state.vesicles[0].points.rowwise() - center.transpose();
}

// Two in shear that pass over each other, no bending: centres by a spectral method.
TEST(SeveralVesicles, APairInShearFollowsTheReference)
{
  Scene scene;
  scene.vesicle.shape.kind = ShapeRequest::Kind::prolate;
  scene.vesicle.shape.reduced_volume = 0.95;
  scene.vesicle.shape.triangles = 320;
  TriangleMesh mesh = make_start_mesh(scene);
  const double tilt = (90 - 32.4) * std::numbers::pi / 180;
  mesh.points =
    (mesh.points * Eigen::AngleAxisd(tilt, Vector3::UnitY()).matrix().transpose()).eval();
  const Points alone = tank_treading(mesh);
  const Eigen::RowVector3d left(-1.5, 0, 0.25);
  System system = system_of(mesh, 2, inextensible);
  system.flow = std::make_shared<Shear>(1);
  StepperSettings settings;
  Evolution evolution(std::move(system), settings, OutputSchedule(1, 3.), 1, {});
  State state = evolution.start({ Points(alone.rowwise() + left), Points(alone.rowwise() - left) });
  for (const auto& [time, x, z, gap] : { std::array{ 1., -1.2459, 0.2778, 0.629 },
         std::array{ 2., -0.9865, 0.3430, 0.361 }, std::array{ 3., -0.7001, 0.4856, 0.213 } })
  {
    while (state.time < time)
      state = evolution.step(state);
    const auto shape = evolution.stepper().shape(state);
    const Vector3 first = shape->vesicles[0].surface->center,
                  second = shape->vesicles[1].surface->center;
    EXPECT_LT((first - Vector3(x, 0, z)).norm(), 1e-2) << time << ": " << first.transpose();
    EXPECT_LT((first + second).norm(), 1e-3) << time;
    EXPECT_NEAR(test::smallest_gap(sides(*shape)).distance, gap, 1e-2) << time;
  }
}

// With a repulsion the same two approach each other more slowly: the gap over the time that it took.
TEST(SeveralVesicles, ARepulsionSlowsTheirApproach)
{
  const TriangleMesh mesh = test::smooth_sphere(80);
  double gap[2];
  for (int on = 0; on < 2; ++on)
  {
    System system = colliding(mesh);
    if (on)
      system.repulsion = Repulsion{ .strength = 20, .range = 0.3 };
    Evolution evolution = evolution_of(std::move(system));
    const State state = steps(evolution, evolution.start(along_z(mesh, 2, 2.3)), 8);
    gap[on] = test::smallest_gap(sides(*evolution.stepper().shape(state))).distance / state.time;
  }
  EXPECT_GT(gap[1], gap[0]);
}

}
}
