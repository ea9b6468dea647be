// Both sets of `vesicle validate`, complete.
#include "Command.h"

#include <gtest/gtest.h>

namespace vesicle::test
{
namespace
{

TEST(ValidateSets, FastSetPasses)
{
  const TemporaryFolder folder;
  const auto outcome = vesicle_command(folder.path(), { "validate", "--plots", "plots" });
  EXPECT_EQ(outcome.code, 0) << outcome.output << outcome.errors;
}

TEST(ValidateSets, FullSetPasses)
{
  const TemporaryFolder folder;
  const auto outcome = vesicle_command(folder.path(), { "validate", "--full", "--plots", "plots" });
  EXPECT_EQ(outcome.code, 0) << outcome.output << outcome.errors;
}

}
}
