// The solver's one parallel loop.

#include "solver/ParallelFor.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace vesicle::test
{

TEST(ParallelFor, CallsTheBodyOnceForEachIndex)
{
  for (const int count : { 0, 1, 3, 1000 })
    for (const int grain : { 1, 64, 2000 })
    {
      std::vector<int> calls(count);
      parallel_for(
        count, [&](int i) { ++calls[i]; }, grain);
      EXPECT_EQ(calls, std::vector<int>(count, 1)) << grain;
    }
}

TEST(ParallelFor, PassesOnAnException)
{
  const auto fails_at_70 = [](int i)
  {
    if (i == 70)
      throw std::runtime_error("at 70");
  };
  EXPECT_THROW(parallel_for(100, fails_at_70), std::runtime_error);
}

// A loop that used oneTBB itself would be out of the thread sanitizer's sight.
TEST(ParallelFor, IsTheOnlyOneInTheSolver)
{
  const std::filesystem::path solver = std::filesystem::path(VESICLE_SOURCE_DIR) / "solver";
  int sources = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(solver))
  {
    if (!entry.is_regular_file() || entry.path().filename() == "ParallelFor.h")
      continue;
    ++sources;
    std::ifstream in(entry.path());
    const std::string text(std::istreambuf_iterator<char>(in), {});
    EXPECT_EQ(text.find("tbb/"), std::string::npos) << entry.path();
  }
  EXPECT_GT(sources, 200);
}

}
