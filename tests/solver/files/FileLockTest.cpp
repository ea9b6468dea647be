#include "solver/files/FileLock.h"

#include "solver/Errors.h"
#include "solver/files/FileBytes.h"
#include "tests/support/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <csignal>

#include <sys/file.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{

bool knows_no_locks = false;

}

// The system's own, or that of a file system without locks.
extern "C" int flock(int descriptor, int operation) noexcept
{
  if (knows_no_locks)
  {
    errno = ENOLCK;
    return -1;
  }
  return static_cast<int>(::syscall(SYS_flock, descriptor, operation));
}

namespace vesicle::test
{
namespace
{

/// Also on a file system without locks.
class FileLockTest : public testing::TestWithParam<bool>
{
protected:
  FileLockTest() { knows_no_locks = GetParam(); }
  ~FileLockTest() override { knows_no_locks = false; }

  std::string refusal() const
  {
    try
    {
      const FileLock lock(file);
    }
    catch (const IoError& error)
    {
      return error.what();
    }
    return "";
  }

  /// A process that holds the lock until it is killed.
  pid_t start_holder() const
  {
    int ready[2];
    EXPECT_EQ(::pipe(ready), 0);
    const pid_t holder = ::fork();
    if (holder == 0)
    {
      const FileLock lock(file);
      const bool told = ::write(ready[1], "x", 1) == 1;
      ::pause();
      ::_exit(told ? 0 : 1);
    }
    char byte = 0;
    EXPECT_EQ(::read(ready[0], &byte, 1), 1);
    ::close(ready[0]);
    ::close(ready[1]);
    return holder;
  }

  TemporaryFolder folder;
  const std::filesystem::path file = folder / "lock";
};

INSTANTIATE_TEST_SUITE_P(FileSystems, FileLockTest, testing::Values(false, true),
  [](const auto& info) { return info.param ? "WithoutLocks" : "WithLocks"; });

}

TEST_P(FileLockTest, IsHeldOnceAndLeavesNothing)
{
  {
    const FileLock lock(file);
    const auto who = "(process " + std::to_string(::getpid()) + " on ";
    EXPECT_TRUE(refusal().starts_with(file.string() + ": locked by another run " + who))
      << refusal();
  }
  EXPECT_FALSE(std::filesystem::exists(file));
  EXPECT_EQ(refusal(), "");
}

TEST_P(FileLockTest, TellsWhoHoldsIt)
{
  EXPECT_EQ(lock_holder(file), "");
  {
    const FileLock lock(file);
    const auto who = "process " + std::to_string(::getpid()) + " on ";
    EXPECT_TRUE(lock_holder(file).starts_with(who)) << lock_holder(file);
    EXPECT_NE(refusal(), ""); // it is held as before
  }
  EXPECT_EQ(lock_holder(file), "");
}

TEST_P(FileLockTest, GoesWithItsHolder)
{
  const pid_t holder = start_holder();
  EXPECT_NE(refusal(), "");
  ::kill(holder, SIGKILL);
  ::waitpid(holder, nullptr, 0);
  EXPECT_TRUE(std::filesystem::exists(file));
  EXPECT_EQ(refusal(), "");
}

TEST_P(FileLockTest, NowhereToWriteIsAnError)
{
  EXPECT_THROW(FileLock(folder / "none/lock"), IoError);
}

TEST_P(FileLockTest, ALeftoverOfAnotherMachineLocksOnlyWhereThereAreNoLocks)
{
  replace_file(file, "1 another-machine\n");
  EXPECT_EQ(refusal().empty(), !knows_no_locks) << refusal();
  EXPECT_EQ(refusal().find("remove this file") != std::string::npos, knows_no_locks);
}

}
