// At the ends of what can be asked for a scene runs and is right, is refused, or stops and says why.

#include "Extremes.h"

#include "solver/scene/SceneFile.h"
#include "solver/simulation/Simulation.h"
#include "solver/simulation/StartMesh.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <sstream>

namespace vesicle::test
{

class Extremes : public testing::TestWithParam<Cell>
{
};

TEST_P(Extremes, EndWell)
{
  const CellResult result = run_cell(GetParam());
  SCOPED_TRACE(GetParam().scene);
  EXPECT_NE(result.end, CellResult::End::wrong) << result.message;
  EXPECT_NE(result.end, CellResult::End::crawls) << result.steps << " steps to t = " << result.time;
  EXPECT_EQ(result.end == CellResult::End::runs, result.message.empty()) << result.message;
  if (result.end == CellResult::End::stopped)
  {
    EXPECT_NE(result.message.find("t = "), std::string::npos) << result.message; // when
  }
}

// Between two others' steps a run makes the steps that it makes alone.
TEST(TwoScenes, OfDifferentSizesInOneProcessDoNotFeelEachOther)
{
  const auto scene_of = [](int triangles, double rate)
  {
    return parse_scene(
      fmt::format("[vesicle]\nshape = \"prolate\"\nreduced_volume = 0.9\ntriangles = {}\n"
                  "[membrane]\nbending_rigidity = 1.0\n[flow]\nkind = \"shear\"\nrate = {}\n"
                  "[time]\nend = 0.2\noutput_every = 0.2\n",
        triangles, rate),
      "scene");
  };
  const Scene scenes[]{ scene_of(80, 1), scene_of(320, 5) };
  Points alone[2];
  for (int s = 0; s < 2; ++s)
  {
    Simulation simulation(scenes[s], make_start_mesh(scenes[s]));
    State state = simulation.start();
    while (!simulation.finished(state))
      state = simulation.step(state);
    alone[s] = simulation.points(state);
  }
  Simulation both[]{ { scenes[0], make_start_mesh(scenes[0]) },
    { scenes[1], make_start_mesh(scenes[1]) } };
  State states[]{ both[0].start(), both[1].start() };
  while (!both[0].finished(states[0]) || !both[1].finished(states[1]))
    for (int s = 0; s < 2; ++s)
      if (!both[s].finished(states[s]))
        states[s] = both[s].step(states[s]);
  for (int s = 0; s < 2; ++s)
    EXPECT_EQ(both[s].points(states[s]), alone[s]);
}

INSTANTIATE_TEST_SUITE_P(Of80Triangles, Extremes, testing::ValuesIn(extremes(80)),
  [](const testing::TestParamInfo<Cell>& info)
  {
    std::string name = std::to_string(info.index) + "_" + info.param.axis + "_" + info.param.value;
    for (char& c : name)
      c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return name;
  });

}
