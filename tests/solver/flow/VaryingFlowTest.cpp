// Flows whose strength changes with time: runs hit the corners, and follow what lies between.

#include "solver/flow/VaryingFlow.h"

#include "solver/Errors.h"
#include "solver/flow/Rotation.h"
#include "solver/flow/Shear.h"
#include "solver/flow/Uniform.h"
#include "solver/scene/SceneFile.h"
#include "solver/simulation/History.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vesicle
{
namespace
{

TEST(VaryingFlow, IsAtATimeTheFlowTimesItsFactor)
{
  const auto flow = with_history(std::make_shared<Shear>(3), { { { 0, 1 }, { 2, 0 } }, {}, 0 });
  const Vector3 x(0.2, 0.4, 0.5);
  EXPECT_EQ(flow->at(0)->velocity_at(x), Vector3(1.5, 0, 0));
  EXPECT_LT((flow->at(1)->velocity_at(x) - Vector3(0.75, 0, 0)).norm(), 1e-9);
  EXPECT_EQ(flow->at(5)->velocity_at(x), Vector3(0, 0, 0));
  EXPECT_EQ(flow->imposed_rate(), 3);
  // In units of 2 and 4 a time is 0.5.
  const auto scaled = flow->dimensionless(2, 4);
  EXPECT_LT((scaled->at(2)->velocity_at(x / 2) - Vector3(0.75 / 4, 0, 0)).norm(), 1e-9);
  EXPECT_EQ(scaled->next_corner(0), 4.);
}

TEST(VaryingFlow, WithoutAHistoryIsTheFlowItself)
{
  const auto shear = std::make_shared<Shear>(3);
  EXPECT_EQ(with_history(shear, {}), shear);
  EXPECT_EQ(flow_at(shear, 7), shear);
  EXPECT_EQ(with_history(nullptr, { {}, {}, 2 }), nullptr);
  EXPECT_EQ(flow_at(nullptr, 7), nullptr);
}

Scene scene_in(std::shared_ptr<const ImposedFlow> flow, FlowHistory history, double end)
{
  Scene scene;
  scene.accuracy.mesh_motion = Scene::MeshMotion::material; // so that the points go with the fluid
  scene.flow = std::move(flow);
  scene.flow_history = std::move(history);
  scene.time.end = end;
  scene.time.output_every = end;
  return scene;
}

History course(const Scene& scene)
{
  return run_to_end(std::make_shared<Simulation>(scene, test::small_prolate()));
}

Points start_of(const History& run)
{
  return run.simulation->start_mesh().points;
}

Points end_of(const History& run)
{
  return run.simulation->points(run.last);
}

// The midpoint rule is exact where the velocity is linear in time: only if every corner is hit is
// the way the integral of the factor, here 1/2 + 0 + (1 − 2)/2 · 1 + (−2) · 1/4 of the velocity.
TEST(VaryingFlow, CarriesAVesicleByTheIntegralOfItsFactor)
{
  const FlowHistory history{ { { 0, 0 }, { 1, 1 }, { 1, 0 }, { 1.5, 0 }, { 1.5, 1 }, { 2.5, -2 } },
    {}, 0 };
  const Vector3 velocity(1, 2, -0.5);
  const History moved = course(scene_in(std::make_shared<Uniform>(velocity), history, 2.75));
  const double way = 0.5 - 0.5 - 0.5;
  EXPECT_LT((Vector3(moved.end().centroid.data()) - way * velocity).norm(), 1e-8);
  for (const double corner : { 1., 1.5, 2.5, 2.75 })
    EXPECT_EQ(std::count_if(moved.rows.begin(), moved.rows.end(),
                [=](const Diagnostics& d) { return d.time == corner; }),
      1)
      << corner;
}

// A shape that neither bends nor deforms turns by the integral of the rate: sin ωt/ω.
TEST(VaryingFlow, TurnsAVesicleByTheIntegralOfItsRate)
{
  const double rate = 1.5, omega = 4, end = 1;
  double error[2];
  for (int level = 0; level < 2; ++level)
  {
    Scene scene =
      scene_in(std::make_shared<Rotation>(rate, Vector3::UnitY()), { {}, {}, omega }, end);
    scene.time.step = level == 0 ? 0.02 : 0.01;
    const History turned = course(scene);
    const double angle = rate * std::sin(omega * end) / omega;
    const Points exact =
      start_of(turned) * Eigen::AngleAxisd(angle, Vector3::UnitY()).toRotationMatrix().transpose();
    error[level] = (end_of(turned) - exact).rowwise().norm().maxCoeff();
  }
  EXPECT_LT(error[1], 5e-4);
  EXPECT_GT(test::order(error[0], error[1]), 1.8) << error[0] << ", " << error[1];
}

// Stopped and turned back, in Stokes flow without a membrane that bends a shape goes back its way.
TEST(VaryingFlow, TurnedBackItUndoesWhatItDid)
{
  const FlowHistory history{ { { 0, 1 }, { 0.5, 1 }, { 0.5, -1 } }, {}, 0 };
  Scene scene = scene_in(std::make_shared<Shear>(1), history, 1);
  scene.time.tolerance = 1e-4;
  const History there_and_back = course(scene);
  EXPECT_LT((end_of(there_and_back) - start_of(there_and_back)).rowwise().norm().maxCoeff(), 2e-3);
  scene.flow_history = {};
  const History there = course(scene);
  EXPECT_GT((end_of(there) - start_of(there)).rowwise().norm().maxCoeff(), 0.3);
}

constexpr const char* text = R"(
[vesicle]
shape = "sphere"
[flow]
kind = "shear"
rate = 3
history = [[0, 0], [1, 1.5], [1, 0]]
period = 2
angular_frequency = 0.5
[time]
end = 1
output_every = 1
)";

TEST(VaryingFlow, IsWhatTheSceneSays)
{
  const Scene scene = parse_scene(text, "s.toml");
  const Scene again = parse_scene(write_scene(scene), "written.toml");
  for (const Scene& s : { scene, again })
  {
    const std::vector<std::array<double, 2>> table{ { 0, 0 }, { 1, 1.5 }, { 1, 0 } };
    EXPECT_EQ(s.flow_history.table, table);
    EXPECT_EQ(s.flow_history.period, 2.);
    EXPECT_EQ(s.flow_history.angular_frequency, 0.5);
  }
}

std::string refusal(const std::string& from, const std::string& to)
{
  std::string changed = text;
  changed.replace(changed.find(from), from.size(), to);
  try
  {
    parse_scene(changed, "s.toml");
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "";
}

TEST(VaryingFlow, RefusesHistoriesThatMakeNoSense)
{
  EXPECT_NE(
    refusal("[1, 1.5], [1, 0]", "[2, 1], [1, 0]").find("goes back from 2 to 1"), std::string::npos);
  EXPECT_NE(refusal("period = 2", "period = 0.5").find("flow.period"), std::string::npos);
  EXPECT_NE(
    refusal("history = [[0, 0], [1, 1.5], [1, 0]]", "").find("repeats nothing"), std::string::npos);
  EXPECT_NE(refusal("[[0, 0], [1, 1.5], [1, 0]]", "[]").find("can't be empty"), std::string::npos);
  EXPECT_NE(refusal("end = 1", "end = \"steady\"").find("varies for ever"), std::string::npos);
}

}
}
