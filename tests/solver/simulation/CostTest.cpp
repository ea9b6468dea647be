#include "solver/simulation/Cost.h"

#include "solver/Errors.h"
#include "solver/scene/SceneFile.h"

#include <gtest/gtest.h>

#include <string>

namespace vesicle
{
namespace
{

Scene scene(const std::vector<std::string>& overrides)
{
  return parse_scene(R"(
    [vesicle]
    shape = "prolate"
    reduced_volume = 0.9
    [time]
    end = 1.0
    output_every = 0.1
    )",
    "scene.toml", ".", overrides);
}

std::string refusal(const std::vector<std::string>& overrides, const Resources& available)
{
  Scene wanted = scene(overrides);
  wanted.file = "folder/scene.toml";
  try
  {
    require_affordable(wanted, wanted.vesicle.shape.triangles, available);
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "";
}

constexpr Resources laptop{ 16e9, 100e9 };

// Resident memory of whole runs of the pear, and what a step took, both at 320, 1,280 and 5,120 triangles:
// 115, 250, 778 MB and 24, 90, 658 ms on Loop's surface, one thread; 62, 124, 893 MB and 3.6, 39, 440 ms
// on flat triangles. Dense matrices: at many triangles 4 times as many take 16 times as much.
TEST(Cost, IsWhatRunsTook)
{
  const Cost loop = cost_of(scene({}), 5120),
             flat = cost_of(scene({ "accuracy.preset=fast" }), 5120);
  EXPECT_NEAR(loop.memory / 0.778e9, 1, 0.1);
  EXPECT_NEAR(flat.memory / 0.893e9, 1, 0.1);
  EXPECT_NEAR(cost_of(scene({}), 1280).memory / 0.250e9, 1, 0.2);
  EXPECT_NEAR(loop.seconds / loop.steps / 0.658, 1, 0.2);
  EXPECT_NEAR(flat.seconds / flat.steps / 0.44, 1, 0.2);
  EXPECT_EQ(loop.frames, 11);
}

// The same of vesicles on equal meshes: pairs of 1,280 and 5,120 triangles each, 64 and 1,000 of 320.
TEST(Cost, VesiclesShareWhatTheirMeshFixes)
{
  const auto several = [](std::size_t count, int triangles)
  {
    Scene all = scene({ "vesicle.triangles=" + std::to_string(triangles) });
    all.companions.assign(count - 1, all.companion());
    return cost_of(all, static_cast<double>(count) * triangles).memory;
  };
  EXPECT_NEAR(several(2, 1280) / 0.293e9, 1, 0.2);
  EXPECT_NEAR(several(2, 5120) / 0.875e9, 1, 0.2);
  EXPECT_NEAR(several(64, 320) / 0.995e9, 1, 0.2);
  EXPECT_NEAR(several(1000, 320) / 13.2e9, 1, 0.2);
}

TEST(Cost, OfWhatIsUsualIsAffordable)
{
  EXPECT_EQ(refusal({}, laptop), "");
  EXPECT_EQ(refusal({ "vesicle.triangles=5120" }, laptop), "");
  EXPECT_EQ(refusal({ "time.end=\"steady\"", "time.output_every=1e-9" }, laptop), "");
}

TEST(Cost, TooMuchIsRefusedWithTheNumberAndTheKey)
{
  const auto expect =
    [](const std::vector<std::string>& overrides, const char* number, const char* key)
  {
    const std::string text = refusal(overrides, laptop);
    EXPECT_TRUE(text.starts_with("folder/scene.toml: ")) << text;
    EXPECT_NE(text.find(number), std::string::npos) << text;
    EXPECT_NE(text.find(key), std::string::npos) << text;
  };
  expect({ "vesicle.triangles=40960", "accuracy.preset=fast" }, "46.3 GB", "vesicle.triangles");
  expect({ "time.output_every=1e-300" }, "1e+300 frames", "time.output_every");
  expect({ "time.step=1e-200" }, "1e+200 steps", "time.step");
  expect({ "time.end=100", "time.output_every=1e-3", "vesicle.triangles=10240" }, "123 GB",
    "time.output_every");
  expect({ "movie.size=[16384, 16384]" }, "17.2 GB", "movie.size");
}

TEST(Cost, TheMachineIsKnown)
{
  const Resources here = resources_for("/nowhere/at/all");
  EXPECT_GT(here.memory, 1e8);
  EXPECT_GT(here.disk, 0);
}

}
}
