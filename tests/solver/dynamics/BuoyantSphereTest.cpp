// The paper's Fig. 4: a sphere with an inextensible membrane rises as a rigid one, U = 2/9 Bo, with
// the tension γ = (Bo/3)(z − z_c) + const, in both formulations.
#include "solver/mesh/shapes/ShapeRequest.h"
#include "solver/mesh/shapes/Shapes.h"
#include "solver/simulation/Simulation.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vesicle
{
namespace
{

struct Errors
{
  double speed, tension, divergence;
};

Errors solve(Scene::Preset preset, int n)
{
  Scene scene;
  scene.gravity = Scene::Gravity{};
  scene.gravity->bond_number = 3;
  scene.time.end = 1;
  scene.accuracy = Scene::preset(preset);
  TriangleMesh sphere = make_shape({ ShapeRequest::Kind::sphere, 20 * n * n, {}, {}, {}, {} });
  Simulation simulation(scene, std::move(sphere));
  const State state = simulation.start();
  const Diagnostics d = simulation.diagnose(state);
  const Eigen::VectorXd z = state.vesicles[0].points.col(2);
  const Eigen::VectorXd exact = z.array() - z.mean();
  const Eigen::VectorXd tension =
    state.vesicles[0].tension.array() - state.vesicles[0].tension.mean();
  return { std::abs(d.velocity[2] / (2. / 3) - 1), (tension - exact).norm() / exact.norm(),
    d.divergence };
}

class BuoyantSphere : public testing::TestWithParam<Scene::Preset>
{
};

TEST_P(BuoyantSphere, ConvergesWithOrderTwo)
{
  const Errors coarse = solve(GetParam(), 4), fine = solve(GetParam(), 8);
  EXPECT_LT(fine.speed, 0.02);
  EXPECT_LT(fine.tension, 0.02);
  if (GetParam() == Scene::Preset::balanced)
    EXPECT_LT(fine.divergence, coarse.divergence); // the tension's filter, of third order
  else
    EXPECT_LT(fine.divergence, 1e-8);
  EXPECT_GT(test::order(coarse.speed, fine.speed), 1.7) << coarse.speed << ", " << fine.speed;
  EXPECT_GT(test::order(coarse.tension, fine.tension), 1.7)
    << coarse.tension << ", " << fine.tension;
}

INSTANTIATE_TEST_SUITE_P(Presets, BuoyantSphere,
  testing::Values(Scene::Preset::paper, Scene::Preset::fast, Scene::Preset::balanced));

}
}
