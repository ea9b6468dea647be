// In a fluid that turns as a rigid body a vesicle turns with it, as if it were at rest.

#include "solver/flow/Rotation.h"

#include "solver/simulation/History.h"
#include "solver/scene/SceneFile.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vesicle
{
namespace
{

const Vector3 axis = Vector3(1, 2, 2) / 3;
constexpr double rate = -2, end = 0.4;

Points turned(const Points& points, double angle)
{
  return points * Eigen::AngleAxisd(angle, axis).toRotationMatrix().transpose();
}

// One turn in 1,000 steps of the midpoint rule, whose error is that of a circle's chords.
TEST(Rotation, CarriesPointsAroundItsAxis)
{
  const Rotation flow(rate, axis);
  Points start(2, 3);
  start << 1, 0, 0, 0.3, -2, 0.5;
  Points x = start;
  const int steps = 1000;
  const double dt = 2 * M_PI / std::abs(rate) / steps;
  for (int i = 0; i < steps; ++i)
    x += dt * flow.velocities(x + 0.5 * dt * flow.velocities(x));
  EXPECT_LT((x - start).rowwise().norm().maxCoeff(), 1e-4);
  EXPECT_LT((flow.velocities(start) - (turned(start, rate * 1e-6) - start) / 1e-6).norm(), 1e-5);
}

Scene scene_of(Scene::Preset preset, double step)
{
  Scene scene;
  scene.accuracy = Scene::preset(preset);
  scene.accuracy.mesh_motion = Scene::MeshMotion::material; // so that the points turn too
  scene.membrane.bending_rigidity = 1;
  scene.time.end = end;
  scene.time.step = step;
  return scene;
}

struct End
{
  Points points;
  double energy;
};

End run(const Scene& scene)
{
  const History run = run_to_end(std::make_shared<Simulation>(scene, test::small_prolate()));
  return { run.simulation->points(run.last), run.end().bending_energy };
}

class RotatingVesicle : public testing::TestWithParam<Scene::Preset>
{
};

// What is left of the difference is the time step's.
TEST_P(RotatingVesicle, KeepsItsShapeAndTurnsWithTheFluid)
{
  double error[2];
  for (int level = 0; level < 2; ++level)
  {
    Scene scene = scene_of(GetParam(), level == 0 ? 0.02 : 0.01);
    const End still = run(scene);
    scene.flow = std::make_shared<Rotation>(rate, axis);
    const End rotating = run(scene);
    error[level] = (rotating.points - turned(still.points, rate * end)).rowwise().norm().maxCoeff();
    EXPECT_NEAR(rotating.energy, still.energy, 1e-3 * still.energy);
  }
  EXPECT_LT(error[1], 1e-3);
  EXPECT_GT(test::order(error[0], error[1]), 1.8) << error[0] << ", " << error[1];
}

INSTANTIATE_TEST_SUITE_P(
  Presets, RotatingVesicle, testing::Values(Scene::Preset::fast, Scene::Preset::balanced));

TEST(Rotation, IsAKindOfTheScene)
{
  const Scene scene = parse_scene(R"(
[vesicle]
shape = "sphere"
[flow]
kind = "rotation"
rate = 3
axis = [0, 2, 0]
[time]
end = 1
output_every = 1
)",
    "s.toml");
  const Scene again = parse_scene(write_scene(scene), "written.toml");
  for (const Scene& s : { scene, again })
  {
    const auto& flow = dynamic_cast<const Rotation&>(*s.flow);
    EXPECT_EQ(flow.rate, 3);
    EXPECT_EQ(flow.axis, Vector3(0, 1, 0));
  }
}

}
}
