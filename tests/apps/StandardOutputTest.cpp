#include "Command.h"

#include <gtest/gtest.h>

namespace vesicle::test
{
namespace
{

class StandardOutput : public testing::Test
{
protected:
  StandardOutput()
  {
    write_scene_file(folder.path());
    EXPECT_EQ(vesicle_command(folder.path(), { "shape", "sphere", "-o", "sphere.vtu" }).code, 0);
  }

  /// `vesicle arguments…` as a shell runs it, so that its output may go anywhere.
  Outcome shell(const std::string& arguments, const std::string& output) const
  {
    return program(
      "/bin/bash", folder.path(), { "-c", VESICLE_COMMAND " " + arguments + " " + output });
  }
  /// The same into a pipe whose reader has left.
  Outcome into_closed_pipe(const std::string& arguments) const
  {
    const std::string pipe = "mkfifo pipe; exec 3<>pipe 4>pipe 3<&-; rm pipe; ";
    return program(
      "/bin/bash", folder.path(), { "-c", pipe + VESICLE_COMMAND + " " + arguments + " >&4" });
  }

  TemporaryFolder folder;
};

const std::vector<std::string> commands{ "info --json sphere.vtu", "info sphere.vtu",
  "shape sphere -o other.vtu", "validate --list", "--help", "run --help",
  "run pear.toml --overwrite --no-movie --no-plots --set time.end=0.02" };

}

TEST_F(StandardOutput, FullIsAnErrorThatIsTold)
{
  for (const auto& command : commands)
  {
    const auto outcome = shell(command, "> /dev/full");
    EXPECT_EQ(outcome.code, 4) << command;
    EXPECT_EQ(
      outcome.errors, "vesicle: standard output: can't be written: No space left on device\n")
      << command;
  }
  EXPECT_TRUE(std::filesystem::exists(folder / "pear/summary.json")); // the run went on
}

TEST_F(StandardOutput, ThatNobodyReadsIsNoReasonForWords)
{
  for (const auto& command : commands)
  {
    const auto outcome = into_closed_pipe(command);
    EXPECT_EQ(outcome.code, 4) << command;
    EXPECT_EQ(outcome.errors, "") << command;
  }
  EXPECT_TRUE(std::filesystem::exists(folder / "pear/summary.json"));
}

TEST_F(StandardOutput, ThatIsNotThereIsNotAFile)
{
  for (const auto& command : commands)
  {
    const auto outcome = shell(command, ">&- 2> errors.txt");
    EXPECT_EQ(outcome.code, 4) << command;
    EXPECT_NE(bytes_of(folder / "errors.txt").find("standard output"), std::string::npos)
      << command;
  }
  EXPECT_EQ(shell(commands.back(), "<&- >&- 2>&-").code, 4);
  EXPECT_EQ(shell(commands.front(), "2>&-").code, 0);
}

}
