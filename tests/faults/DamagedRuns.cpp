#include "tests/faults/DamagedRuns.h"

#include "tests/faults/FaultRuns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <iostream>
#include <random>

namespace vesicle::test
{
namespace
{

constexpr const char* run_file = "pear.h5";

/// The damage of that number. Half of the places are in the first 20 KiB, where the checksums and
/// HDF5's own structure are.
std::string damaged(std::string bytes, int number)
{
  std::mt19937_64 random(static_cast<std::uint64_t>(number));
  const std::size_t reach =
    number % 2 == 0 ? bytes.size() : std::min<std::size_t>(bytes.size(), 20480);
  const std::size_t place = random() % reach;
  const auto at = bytes.begin() + static_cast<long>(place);
  const auto overwrite = [&](std::size_t count, const auto& byte)
  { std::generate_n(at, std::min(count, bytes.size() - place), byte); };
  const auto any = [&] { return static_cast<char>(random()); };
  switch (number / 2 % 5)
  {
    case 0:
      *at = static_cast<char>(*at ^ (1 << random() % 8));
      break;
    case 1:
      overwrite(8, any);
      break;
    case 2:
      overwrite(4096, [] { return '\0'; });
      break;
    case 3:
      overwrite(512, any);
      break;
    default:
      bytes.resize(place);
  }
  return bytes;
}

}

void expect_damage_to_be_noticed(int count)
{
  FaultRuns runs({ "--no-movie", "--no-plots" });
  const Fault halfway{ runs.calls() * 2 / 3, "kill", false };
  ASSERT_EQ(runs.run("run", halfway).code, 128 + SIGKILL);
  const auto folder = runs.folder() / "run", copy = runs.folder() / "copy";
  const std::string bytes = bytes_of(folder / run_file);
  int refused = 0;
  for (int number = 0; number < count; ++number)
  {
    SCOPED_TRACE("damage " + std::to_string(number));
    std::filesystem::remove_all(copy);
    std::filesystem::copy(folder, copy, std::filesystem::copy_options::recursive);
    std::ofstream(copy / run_file, std::ios::binary) << damaged(bytes, number);
    const Files before = files_in(copy);
    const auto outcome = runs.run("copy", {}, { "--resume" });
    if (outcome.code == 0)
    {
      EXPECT_EQ(differences(files_in(copy), runs.undisturbed()), std::vector<std::string>{});
      continue;
    }
    ++refused;
    EXPECT_EQ(outcome.code, 4) << outcome.errors;
    EXPECT_NE(outcome.errors.find("copy/pear.h5: is "), std::string::npos) << outcome.errors;
    EXPECT_EQ(differences(files_in(copy), before), std::vector<std::string>{});
  }
  EXPECT_GT(refused, count / 4);
  std::cout << count << " damaged run files: " << refused << " refused, " << count - refused
            << " gone on with\n";
}

}
