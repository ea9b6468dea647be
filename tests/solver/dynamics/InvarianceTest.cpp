// Ten steps of fixed size on a rotated, translated, renumbered or SI-scaled vesicle are the same
// ten steps.
#include "solver/simulation/Simulation.h"
#include "solver/flow/Shear.h"
#include "solver/mesh/MeshIntegrals.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

namespace vesicle
{
namespace
{

constexpr double agreement = 1e-9; // of r0

// Irregular, yet smooth enough for a Loop surface.
TriangleMesh start()
{
  return test::mapped(test::jittered_sphere(4, 0.08),
    [](const Vector3& d) -> Vector3 {
      return { 1.4 * d.x(), 1.0 * d.y(), 0.9 * d.z() };
    });
}

class Invariance : public testing::TestWithParam<Scene::Preset>
{
protected:
  Scene rising() const;
  Scene sheared() const;
};

Scene Invariance::rising() const
{
  Scene scene;
  scene.accuracy = Scene::preset(GetParam());
  scene.membrane.bending_rigidity = 1;
  scene.gravity = Scene::Gravity{};
  scene.gravity->bond_number = 5;
  scene.time.end = 1;
  scene.time.step = 0.01;
  scene.accuracy.linear_tolerance = 1e-12;
  return scene;
}

// Shear with a little of everything: the flow is fixed in space.
Scene Invariance::sheared() const
{
  Scene scene = rising();
  scene.flow = std::make_shared<Shear>(2);
  return scene;
}

Points ten_steps(const Scene& scene, const TriangleMesh& mesh)
{
  Simulation simulation(scene, mesh);
  State state = simulation.start();
  for (int i = 0; i < 10; ++i)
    state = simulation.step(state);
  return simulation.points(state);
}

double largest(const Points& difference)
{
  return difference.rowwise().norm().maxCoeff();
}

TEST_P(Invariance, RotationAboutGravity)
{
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vector3::UnitZ()).toRotationMatrix();
  const TriangleMesh mesh = start();
  const TriangleMesh turned{ mesh.points * turn.transpose(), mesh.triangles };
  const Points expected = ten_steps(rising(), mesh) * turn.transpose();
  EXPECT_LT(largest(ten_steps(rising(), turned) - expected), agreement);
}

TEST_P(Invariance, AnyRotationInAFluidAtRest)
{
  Scene scene = rising();
  scene.gravity.reset();
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(1.1, Vector3(1, -2, 0.5).normalized()).toRotationMatrix();
  const TriangleMesh mesh = start();
  const TriangleMesh turned{ mesh.points * turn.transpose(), mesh.triangles };
  const Points expected = ten_steps(scene, mesh) * turn.transpose();
  EXPECT_LT(largest(ten_steps(scene, turned) - expected), agreement);
}

TEST_P(Invariance, TranslationAlsoFarUpWhereZIsLarge)
{
  const TriangleMesh mesh = start();
  const Points expected = ten_steps(rising(), mesh);
  TriangleMesh moved = mesh;
  const Eigen::RowVector3d shift(3, -5, 1000);
  moved.points.rowwise() += shift;
  EXPECT_LT(largest(ten_steps(rising(), moved) - (expected.rowwise() + shift)), agreement);
}

TEST_P(Invariance, RenumberingOfPointsAndTriangles)
{
  const auto [other, order] = test::renumbered(start());
  const Points expected = ten_steps(sheared(), start()), found = ten_steps(sheared(), other);
  Points difference(found.rows(), 3);
  for (int i = 0; i < found.rows(); ++i)
    difference.row(i) = found.row(i) - expected.row(order[i]);
  EXPECT_LT(largest(difference), agreement);
}

TEST_P(Invariance, SiUnits)
{
  const double r0 = 1e-5, EB = 1e-19, mu = 1e-3, t0 = mu * r0 * r0 * r0 / EB;
  const TriangleMesh mesh = start();
  const double size = std::cbrt(3 * flat_volume(mesh) / (4 * M_PI));
  Scene si = sheared();
  si.membrane.bending_rigidity = EB;
  si.fluid.viscosity = mu;
  si.flow = std::make_shared<Shear>(2 / t0);
  si.time.end = t0;
  si.time.step = 0.01 * t0;
  const TriangleMesh small{ mesh.points / size * r0, mesh.triangles };
  const TriangleMesh unit{ mesh.points / size, mesh.triangles };
  EXPECT_LT(largest(ten_steps(si, small) / r0 - ten_steps(sheared(), unit)), agreement);
}

TEST_P(Invariance, NoBitDependsOnTheNumberOfThreads)
{
  Points found[2];
  for (int threads : { 1, 3 })
  {
    tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    found[threads > 1] = ten_steps(sheared(), start());
  }
  EXPECT_EQ(found[0], found[1]);
}

TEST_P(Invariance, ARestoredStateGoesOnBitForBit)
{
  Simulation simulation(sheared(), start());
  State state = simulation.start();
  for (int i = 0; i < 4; ++i)
    state = simulation.step(state);
  const State saved = state;
  for (int i = 0; i < 4; ++i)
    state = simulation.step(state);
  Simulation other(sheared(), start()); // nothing cached
  State again = saved;
  for (int i = 0; i < 4; ++i)
    again = other.step(again);
  EXPECT_EQ(again.vesicles[0].points, state.vesicles[0].points);
  EXPECT_EQ(again.vesicles[0].tension, state.vesicles[0].tension);
  EXPECT_EQ(again.controller.next_step, state.controller.next_step);
}

INSTANTIATE_TEST_SUITE_P(
  Presets, Invariance, testing::Values(Scene::Preset::fast, Scene::Preset::balanced));

}
}
