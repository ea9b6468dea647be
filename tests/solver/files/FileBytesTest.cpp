#include "solver/files/FileBytes.h"

#include "solver/Errors.h"
#include "tests/solver/support/FullDisk.h"
#include "tests/support/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <fstream>
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
}

TEST(FileBytes, LinksStayLinks)
{
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "disk");
  std::filesystem::create_symlink("disk/file.txt", folder / "file.txt");
  for (const char* text : { "new", "newer" })
  {
    replace_file(folder / "file.txt", text);
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "file.txt"));
    EXPECT_EQ(read_file(folder / "disk/file.txt"), text);
  }
  const std::filesystem::directory_iterator files(folder / "disk");
  EXPECT_EQ(std::distance(begin(files), end(files)), 1);
}

TEST(FileBytes, WhatOthersWroteIsFinished)
{
  const TemporaryFolder folder;
  const auto file = folder / "film.mp4";
  std::ofstream(unfinished_name(file)) << "pictures";
  finish_file(file);
  EXPECT_EQ(read_file(file), "pictures");
  EXPECT_FALSE(std::filesystem::exists(unfinished_name(file)));
  EXPECT_EQ(message_of([&] { finish_file(file); }),
    file.string() + ": can't be written: No such file or directory");
  EXPECT_EQ(read_file(file), "pictures");
}

TEST(FileBytes, FailuresNameTheFileAndTheReasonAndLeaveNothing)
{
  const TemporaryFolder folder;
  const auto nowhere = folder / "nowhere/file.txt";
  EXPECT_EQ(message_of([&] { replace_file(nowhere, "text"); }),
    nowhere.string() + ": can't be written: No such file or directory");
  std::filesystem::create_directories(folder / "taken/by a folder");
  EXPECT_NE(message_of([&] { replace_file(folder / "taken", "text"); }), "no IoError");
  std::filesystem::remove_all(folder / "taken");
  const FullDisk full(4);
  EXPECT_NE(message_of([&] { replace_file(folder / "file", "longer"); }), "no IoError");
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
