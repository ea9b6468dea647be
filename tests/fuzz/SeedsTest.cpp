// Each target over its seeds, and over some hundreds or thousands damaged forms of them, the same each time.
#include "tests/fuzz/Seeds.h"
#include "tests/fuzz/Targets.h"

#include "solver/files/FileBytes.h"

#include <gtest/gtest.h>

#include <ostream>
#include <string>

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
    SCOPED_TRACE("damage " + std::to_string(i));
    EXPECT_NO_THROW(GetParam().run(damaged_seed(seeds, i)));
  }
}

INSTANTIATE_TEST_SUITE_P(Targets, Fuzz,
  testing::Values(Target{ "meshes", meshes, 20000 }, Target{ "scenes", scenes, 20000 },
    Target{ "run_files", run_files, 500 }, Target{ "xml_surfaces", xml_surfaces, 1000 },
    Target{ "velocity_fields", velocity_fields, 2000 }, Target{ "filters", filters, 1000 }),
  [](const auto& target) { return target.param.name; });

}
