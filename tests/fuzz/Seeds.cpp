#include "tests/fuzz/Seeds.h"

#include "solver/files/FileBytes.h"

#include "tests/support/Damage.h"

#include <algorithm>
#include <random>

namespace vesicle::fuzz
{
namespace
{

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder)
{
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}

std::vector<std::filesystem::path> seeds_of(const std::string& target)
{
  const std::filesystem::path source = VESICLE_SOURCE_DIR;
  auto seeds = files_in(source / "tests/fuzz/seeds" / target);
  if (target == "scenes")
    for (const auto& scene : files_in(source / "data/scenes"))
      seeds.push_back(scene);
  return seeds;
}

std::string damaged_seed(const std::vector<std::filesystem::path>& seeds, int number)
{
  const auto& seed = seeds[static_cast<std::size_t>(number) % seeds.size()];
  std::mt19937 random(static_cast<unsigned>(number));
  return test::damaged(read_file(seed), 1 + random() % 4, random);
}

}
