#include "solver/files/FileBytes.h"

#include "solver/Errors.h"
#include "tests/solver/support/FullDisk.h"
#include "tests/support/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <functional>

namespace vesicle::test
{
namespace
{

std::string message_of(const std::function<void()>& work)
{
  try
  {
    work();
  }
  catch (const IoError& error)
  {
    return error.what();
  }
  return "no IoError";
}

}

TEST(FileBytes, AreThoseThatWereWritten)
{
  const TemporaryFolder folder;
  const std::string bytes("a\0b\r\n", 5);
  replace_file(folder / "file.txt", bytes);
  EXPECT_EQ(read_file(folder / "file.txt"), bytes);
  replace_file(folder / "file.txt", "");
  EXPECT_EQ(read_file(folder / "file.txt"), "");
  write_to_disk(folder / "file.txt", bytes, IfExists::replace);
  EXPECT_EQ(read_file(folder / "file.txt"), bytes);
}

TEST(FileBytes, AnExistingFileIsKeptWhereThatIsAskedFor)
{
  const TemporaryFolder folder;
  write_to_disk(folder / "file", "old", IfExists::fail);
  const auto message = message_of([&] { write_to_disk(folder / "file", "new", IfExists::fail); });
  EXPECT_NE(message.find("file: can't be written: File exists"), std::string::npos) << message;
  EXPECT_EQ(read_file(folder / "file"), "old");
}

TEST(FileBytes, FailuresNameTheFileAndTheReasonAndLeaveNothing)
{
  const TemporaryFolder folder;
  const auto nowhere = folder / "nowhere/file.txt";
  EXPECT_EQ(message_of([&] { replace_file(nowhere, "text"); }),
    nowhere.string() + ": can't be written: No such file or directory");
  EXPECT_EQ(message_of([&] { write_to_disk(nowhere, "text", IfExists::replace); }),
    nowhere.string() + ": can't be written: No such file or directory");
  std::filesystem::create_directories(folder / "taken/by a folder");
  EXPECT_NE(message_of([&] { replace_file(folder / "taken", "text"); }), "no IoError");
  std::filesystem::remove_all(folder / "taken");
  const FullDisk full(4);
  EXPECT_NE(message_of([&] { replace_file(folder / "file", "longer"); }), "no IoError");
  EXPECT_NE(
    message_of([&] { write_to_disk(folder / "file", "longer", IfExists::replace); }), "no IoError");
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(FileBytes, DevicesAreWrittenToAndStay)
{
  replace_file("/dev/null", "text");
  EXPECT_EQ(message_of([] { replace_file("/dev/full", "text"); }),
    "/dev/full: can't be written: No space left on device");
  EXPECT_TRUE(std::filesystem::exists("/dev/full"));
}

}
