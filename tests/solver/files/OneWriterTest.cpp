// Nothing but solver/files writes to a disk: what is written elsewhere could be lost unnoticed. Nor
// does anything else ask what is there: std::filesystem throws for names that the system doesn't take.

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

namespace vesicle::test
{
namespace
{

using std::filesystem::path;

/// How C++ and C programs open files for writing.
constexpr std::array ways{ "std::ofstream", "std::fstream", "fopen(", "O_WRONLY", "O_RDWR",
  "O_CREAT", "::rename(", "filesystem::rename", "H5F_ACC_RDWR", "create_directories" };

/// Each opens /dev/null, in the place of a standard stream.
const std::set<std::string> exceptions{ "apps/StandardOutput.cpp", "render/Ffmpeg.cxx" };

bool is_source(const path& file)
{
  const auto ending = file.extension();
  return ending == ".cpp" || ending == ".cxx" || ending == ".h";
}

/// Expects none of the words in any source but those of solver/files and the exceptions.
template<std::size_t size>
void expect_none(
  const std::array<const char*, size>& words, const std::set<std::string>& exceptions)
{
  const path root = VESICLE_SOURCE_DIR;
  int sources = 0;
  for (const char* folder : { "solver", "vtkfilters", "render", "apps" })
  {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder))
    {
      const std::string name = std::filesystem::relative(entry.path(), root).string();
      if (!is_source(entry.path()) || name.starts_with("solver/files/") ||
        exceptions.contains(name))
      {
        continue;
      }
      ++sources;
      std::ifstream in(entry.path());
      const std::string text(std::istreambuf_iterator<char>(in), {});
      for (const char* word : words)
      {
        EXPECT_EQ(text.find(word), std::string::npos) << name << ": " << word;
      }
    }
  }
  EXPECT_GT(sources, 200);
}

}

TEST(OneWriter, NoOtherSourceOpensFilesForWriting)
{
  expect_none(ways, exceptions);
}

TEST(OneWriter, NoOtherSourceAsksWhatIsThere)
{
  constexpr std::array ways_to_ask{ "filesystem::exists(", "filesystem::is_regular_file(",
    "filesystem::is_directory(" };
  expect_none(ways_to_ask, {});
}

}
