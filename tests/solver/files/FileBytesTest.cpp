#include "solver/files/FileBytes.h"

#include "solver/Errors.h"
#include "tests/solver/support/FullDisk.h"
#include "tests/support/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <functional>
#include <thread>

#include <sys/stat.h>

namespace vesicle::test
{
namespace
{

template<class Error>
std::string what_of(const std::function<void()>& work)
{
  try
  {
    work();
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return "no error";
}

constexpr auto message_of = what_of<IoError>;
constexpr auto refusal_of = what_of<InputError>;

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
  EXPECT_NE(message_of([&] { replace_file(folder / "taken", "text"); }), "no error");
  std::filesystem::remove_all(folder / "taken");
  const FullDisk full(4);
  EXPECT_NE(message_of([&] { replace_file(folder / "file", "longer"); }), "no error");
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(FileBytes, PipesAreReadToTheirEnd)
{
  const TemporaryFolder folder;
  const auto pipe = folder / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::string bytes(200000, 'x'); // more than a pipe holds
  std::jthread writer([&] { std::ofstream(pipe, std::ios::binary) << bytes; });
  EXPECT_EQ(read_file(pipe), bytes);
}

TEST(FileBytes, APipeWithoutAWriterIsRefused)
{
  const TemporaryFolder folder;
  const auto pipe = folder / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(refusal_of([&] { read_file(pipe, std::chrono::milliseconds(10)); }),
    pipe.string() +
      ": is a pipe that nobody wrote to; start the program that does, or name a file");
}

TEST(FileBytes, FoldersAndDevicesArentRead)
{
  EXPECT_EQ(refusal_of([] { read_file("/dev"); }), "/dev: is a folder; name a file");
  EXPECT_EQ(refusal_of([] { read_file("/dev/zero"); }),
    "/dev/zero: is a device or a socket; name a file or a pipe");
}

TEST(FileBytes, DevicesAreWrittenToAndStay)
{
  replace_file("/dev/null", "text");
  EXPECT_EQ(message_of([] { replace_file("/dev/full", "text"); }),
    "/dev/full: can't be written: No space left on device");
  EXPECT_TRUE(std::filesystem::exists("/dev/full"));
}

}
