// Every shipped scene as it is.

#include "Command.h"
#include "RunFiles.h"
#include "ShippedScenes.h"

#include <gtest/gtest.h>

namespace vesicle::test
{
namespace
{

class WholeShippedScene : public testing::TestWithParam<std::filesystem::path>
{
};

}

TEST_P(WholeShippedScene, RunsToItsEnd)
{
  const TemporaryFolder folder;
  const auto outcome = vesicle_command(folder.path(), { "run", GetParam().string(), "-o", "run" });
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.errors, "");
  expect_complete_run(folder / "run", 2);
}

INSTANTIATE_TEST_SUITE_P(ShippedScenes, WholeShippedScene, testing::ValuesIn(shipped_scenes()),
  [](const auto& info) { return test_name(info.param); });

}
