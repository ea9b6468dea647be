// Kills a program in each of its writes to the run file, halfway through the bytes, and looks
// whether a run can go on from what is left.

#include "TestRun.h"

#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>

using namespace vesicle;
using namespace vesicle::testing_support;

namespace
{

constexpr int no_death = -1;
int writes_to_live = no_death; ///< counts down; at 0 the program dies
constexpr int killed = 17;     ///< exit status then

bool last_write()
{
  return writes_to_live != no_death && writes_to_live-- == 0;
}

}

// Called instead of the C library's.
extern "C" ssize_t pwrite(int file, const void* bytes, size_t size, off_t offset)
{
  if (last_write())
  {
    ::syscall(SYS_pwrite64, file, bytes, size / 2, offset);
    ::_exit(killed);
  }
  return ::syscall(SYS_pwrite64, file, bytes, size, offset);
}

extern "C" ssize_t pwrite64(int file, const void* bytes, size_t size, off_t offset)
{
  return pwrite(file, bytes, size, offset);
}

extern "C" ssize_t write(int file, const void* bytes, size_t size)
{
  if (file > 2 && last_write())
  {
    ::syscall(SYS_write, file, bytes, size / 2);
    ::_exit(killed);
  }
  return ::syscall(SYS_write, file, bytes, size);
}

extern "C" int rename(const char* from, const char* to)
{
  if (last_write())
  {
    ::_exit(killed);
  }
  return static_cast<int>(::syscall(SYS_rename, from, to));
}

namespace
{

constexpr int before = 254; ///< steps; a few more and the file is enlarged
constexpr int after = 5;

/// Appends in another process that dies in its write number `write`. False if it got to the end.
bool append_and_die(const std::filesystem::path& file, int write)
{
  const pid_t child = ::fork();
  if (child == 0)
  {
    writes_to_live = write;
    RunFile run = RunFile::open(file);
    for (int i = before; i < before + after; ++i)
    {
      run.append(state(i), row(i));
    }
    run.close();
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_TRUE(WEXITSTATUS(status) == 0 || WEXITSTATUS(status) == killed) << WEXITSTATUS(status);
  return WEXITSTATUS(status) == killed;
}

/// A file as a killed program leaves it: with room for more rows.
void make_file(const std::filesystem::path& file)
{
  const pid_t child = ::fork();
  if (child == 0)
  {
    RunFile run = RunFile::create(file, header());
    for (int i = 0; i < before; ++i)
    {
      run.append(state(i), row(i));
    }
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_EQ(status, 0);
}

}

TEST(RunFileCrash, AnyWriteMayBeTheLast)
{
  const auto folder = empty_folder("run-file-crash");
  const auto original = folder / "original.h5";
  const auto file = folder / "run.h5";
  make_file(original);

  int write = 0;
  std::size_t rows_before = before;
  for (bool died = true; died; ++write)
  {
    SCOPED_TRACE("killed in write " + std::to_string(write));
    std::filesystem::copy_file(original, file, std::filesystem::copy_options::overwrite_existing);
    died = append_and_die(file, write);

    RunFile run = RunFile::open(file);
    const auto rows = run.series();
    ASSERT_GE(rows.size(), rows_before) << "a committed row was lost";
    rows_before = rows.size();
    const auto last = static_cast<std::int64_t>(rows.size()) - 1;
    EXPECT_EQ(rows.back(), row(last));
    EXPECT_EQ(rows.front(), row(0));
    EXPECT_TRUE(same_bits(run.state(), state(last)));

    run.append(state(last + 1), row(last + 1));
    EXPECT_EQ(run.series().size(), rows.size() + 1);
    EXPECT_TRUE(same_bits(run.state(), state(last + 1)));
  }
  EXPECT_EQ(rows_before, static_cast<std::size_t>(before + after));
  EXPECT_GT(write, after * 4) << "the writes weren't caught";
  std::filesystem::remove_all(folder);
}
