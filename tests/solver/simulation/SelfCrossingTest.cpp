// A run whose membrane passes through itself ends at the next output time, and keeps what is good.

#include "solver/simulation/Simulation.h"

#include "solver/Errors.h"
#include "solver/mesh/SelfCrossing.h"
#include "solver/mesh/shapes/GeodesicSphere.h"
#include "solver/scene/SceneFile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace vesicle
{
namespace
{

constexpr double gap = 0.01;

/// A sphere with a dent from the top down to 0.01 above the bottom, and the number of its tip.
struct Dented
{
  TriangleMesh mesh = geodesic_sphere(8);
  Eigen::Index tip = 0;

  Dented()
  {
    mesh.points.col(2).maxCoeff(&tip);
    const Vector3 top = mesh.points.row(tip);
    for (auto x : mesh.points.rowwise())
      x[2] -= (2 * top[2] - gap) * std::exp(-(x.transpose() - top).squaredNorm() / 0.15);
  }
};

// Each step is an output; the nodes go on with the velocities that the state has.
const char* const scene_text = R"(
name = "dent"
[vesicle]
file = "dent.obj"
[membrane]
bending_rigidity = 1.0
[flow]
kind = "uniform"
velocity = [1, 0, 0]
[time]
end = 1.0
step = 1e-9
output_every = 1e-9
[accuracy]
preset = "paper"
)";

}

TEST(SelfCrossing, EndsARunAtTheNextOutputTime)
{
  const Dented dented;
  ASSERT_FALSE(find_self_crossing(dented.mesh));
  Simulation simulation(parse_scene(scene_text, "dent.toml"), dented.mesh);
  State state = simulation.start();
  EXPECT_NO_THROW(simulation.step(state));

  // The tip alone, to as far beyond the bottom as it is above.
  VesicleState& vesicle = state.vesicles[0];
  vesicle.node_velocity(dented.tip, 2) =
    -2 * gap / simulation.scales().length / state.controller.next_step;
  const State before = state;
  try
  {
    simulation.step(state);
    FAIL() << "the step is accepted";
  }
  catch (const NumericalError& error)
  {
    const std::string text = error.what();
    EXPECT_NE(
      text.find("t = 1e-09: the membrane passes through itself, triangles "), std::string::npos)
      << text;
  }
  EXPECT_EQ(state.vesicles[0].points, before.vesicles[0].points);
  EXPECT_EQ(state.time, before.time);
}

}
