// A coarse and short form of every shipped scene, with its movie and plots.

#include "Command.h"
#include "RunFiles.h"
#include "ShippedScenes.h"

#include "solver/scene/SceneFile.h"

#include <gtest/gtest.h>

namespace vesicle::test
{
namespace
{

const std::vector<std::string> coarse_and_short{ "--set", "vesicle.triangles=120", "--set",
  "time.end=0.05", "--set", "time.output_every=0.025", "--set", "movie.size=[320, 180]" };

std::vector<std::string> run_of(
  const std::filesystem::path& scene, const std::vector<std::string>& more = {})
{
  std::vector<std::string> arguments{ "run", scene.string(), "-o", "run" };
  arguments.insert(arguments.end(), coarse_and_short.begin(), coarse_and_short.end());
  // Some things are had on Loop's surface only, which "fast" hasn't.
  const Scene read = read_scene(scene);
  if (read.vesicles() == 1 && read.accuracy.mesh_motion != Scene::MeshMotion::adaptive &&
    read.fluid.viscosity_ratio == 1 && read.membrane.surface_viscosity == 0 &&
    !read.membrane.shear_modulus && !read.wall)
    arguments.insert(arguments.end(), { "--set", "accuracy.preset=fast" });
  if (read.vesicles() > 8)
    arguments.insert(arguments.end(), { "--set", "vesicle.triangles=60" });
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

class ShippedScene : public testing::TestWithParam<std::filesystem::path>
{
};

}

TEST_P(ShippedScene, RunsToItsEnd)
{
  const TemporaryFolder folder;
  const auto outcome = vesicle_command(folder.path(), run_of(GetParam()));
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.errors, "");
  expect_complete_run(folder / "run", 3);
}

INSTANTIATE_TEST_SUITE_P(ShippedScenes, ShippedScene, testing::ValuesIn(shipped_scenes()),
  [](const auto& info) { return test_name(info.param); });

// Across the way it has velocities in two directions, so that its chart has lines named x and z.
TEST(ShippedScenes, APearThatGoesAslantRunsToItsEnd)
{
  const TemporaryFolder folder;
  const auto outcome = vesicle_command(folder.path(),
    run_of(VESICLE_SOURCE_DIR "/data/scenes/pear.toml", { "--set", "vesicle.axis=[1, 0, 1]" }));
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.errors, "");
  expect_complete_run(folder / "run", 3);
  EXPECT_TRUE(std::filesystem::exists(folder / "run/plots/velocity.png") || !draws(folder / "run"));
}

}
