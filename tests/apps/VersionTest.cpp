// One version, wherever it is told.

#include "Command.h"

#include "solver/files/FileBytes.h"

#include <gtest/gtest.h>

#include <regex>
#include <string>

namespace vesicle::test
{

TEST(Version, IsToldWithWhatTheProgramWasBuiltWith)
{
  const TemporaryFolder folder;
  const Outcome outcome = vesicle_command(folder.path(), { "--version" });
  EXPECT_EQ(outcome.code, 0);
  EXPECT_TRUE(std::regex_search(outcome.output, std::regex("^vesicle \\d+\\.\\d+\\.\\d+\n")));
  for (const char* name : { "vtk", "eigen", "hdf5", "tbb", "compiler", "build", "blas_kernel" })
  {
    EXPECT_TRUE(std::regex_search(outcome.output, std::regex("\n  " + std::string(name) + " +\\S")))
      << name;
  }
}

TEST(Version, IsTheOneOfTheCitationAndTheChanges)
{
  const TemporaryFolder folder;
  const std::string told = vesicle_command(folder.path(), { "--version" }).output;
  const std::string version = told.substr(8, told.find('\n') - 8);
  const std::filesystem::path source = VESICLE_SOURCE_DIR;
  EXPECT_NE(
    read_file(source / "CITATION.cff").find("\nversion: " + version + "\n"), std::string::npos);
  EXPECT_NE(read_file(source / "packaging/conda/meta.yaml").find("version = \"" + version + "\""),
    std::string::npos);
  const std::string changes = read_file(source / "CHANGELOG.md");
  EXPECT_EQ(changes.find("\n## " + version), changes.find("\n## ")) << "the newest comes first";
}

}
