// Each target over its seeds, and over some hundreds or thousands damaged forms of them, the same each time.
#include "tests/fuzz/Targets.h"

#include "solver/files/FileBytes.h"

#include "tests/support/Damage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <random>
#include <string>
#include <vector>

namespace vesicle::fuzz
{
namespace
{

struct Target
{
  std::string name;
  void (*run)(std::string_view);
  int mutations; ///< of all seeds together
};

void PrintTo(const Target& target, std::ostream* out)
{
  *out << target.name;
}

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder)
{
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

const std::filesystem::path source = VESICLE_SOURCE_DIR;

std::vector<std::filesystem::path> seeds_of(const std::string& target)
{
  auto seeds = files_in(source / "tests/fuzz/seeds" / target);
  if (target == "scenes")
    for (const auto& scene : files_in(source / "data/scenes"))
      seeds.push_back(scene);
  return seeds;
}

class Fuzz : public testing::TestWithParam<Target>
{
};

}

TEST_P(Fuzz, SeedsAreTakenWithoutAFault)
{
  const auto seeds = seeds_of(GetParam().name);
  ASSERT_FALSE(seeds.empty());
  for (const auto& seed : seeds)
  {
    SCOPED_TRACE(seed.string());
    EXPECT_NO_THROW(GetParam().run(read_file(seed)));
  }
  EXPECT_NO_THROW(GetParam().run(""));
}

TEST_P(Fuzz, DamagedSeedsAreTakenWithoutAFault)
{
  const auto seeds = seeds_of(GetParam().name);
  for (int i = 0; i < GetParam().mutations; ++i)
  {
    const auto& seed = seeds[static_cast<std::size_t>(i) % seeds.size()];
    SCOPED_TRACE(seed.string() + ", damage " + std::to_string(i));
    std::mt19937 random(static_cast<unsigned>(i));
    const std::string bytes = test::damaged(read_file(seed), 1 + random() % 4, random);
    EXPECT_NO_THROW(GetParam().run(bytes));
  }
}

INSTANTIATE_TEST_SUITE_P(Targets, Fuzz,
  testing::Values(Target{ "meshes", meshes, 20000 }, Target{ "scenes", scenes, 20000 },
    Target{ "run_files", run_files, 500 }, Target{ "xml_surfaces", xml_surfaces, 1000 },
    Target{ "filters", filters, 1000 }),
  [](const auto& target) { return target.param.name; });

}
