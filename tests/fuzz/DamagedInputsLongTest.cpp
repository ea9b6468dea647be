// 20,000 damaged files, other ones than the default tests take, in processes that are watched: how
// many crash, take 10 seconds or 2 GB, or are accepted though they shouldn't be.
#include "tests/fuzz/Fault.h"
#include "tests/fuzz/Seeds.h"
#include "tests/fuzz/Targets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <iostream>
#include <string>
#include <thread>

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace vesicle::fuzz
{
namespace
{

using std::chrono::steady_clock;

constexpr int first_damage = 1000000; // behind those of SeedsTest.cpp
constexpr std::chrono::seconds too_long(10);
constexpr long too_much = 2000000; // kB

struct Input
{
  const char* target;
  void (*take)(std::string_view);
  int count;
};

constexpr Input inputs[] = { { "meshes", meshes, 8000 }, { "xml_surfaces", xml_surfaces, 4000 },
  { "velocity_fields", velocity_fields, 4000 }, { "scenes", scenes, 5000 },
  { "run_files", run_files, 3000 } };

struct Tally
{
  int taken = 0, crashes = 0, hangs = 0, large = 0, wrong = 0;
  long memory = 0; ///< the most, kB
};

/// What the process that takes the files says to the one that watches.
struct Progress
{
  std::atomic<int> next = 0, wrong = 0;
};

[[noreturn]] void take_all(const Input& input, Progress& progress)
{
  const auto seeds = seeds_of(input.target);
  for (int i = progress.next; i < input.count; progress.next = ++i)
    try
    {
      input.take(damaged_seed(seeds, first_damage + i));
    }
    catch (const Fault& fault)
    {
      ++progress.wrong;
      std::cerr << input.target << ", damage " << first_damage + i << ": " << fault.what() << '\n';
    }
  _exit(0);
}

/// Until the process ends, or has had too long for a file; then it is killed.
struct Ending
{
  bool whole, hung;
  long memory;
};

Ending watch(pid_t process, const Progress& progress)
{
  int seen = -1, status = 0;
  auto since = steady_clock::now();
  rusage used = {};
  bool hung = false;
  while (wait4(process, &status, WNOHANG, &used) == 0)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (progress.next != seen)
    {
      seen = progress.next;
      since = steady_clock::now();
    }
    else if (!hung && steady_clock::now() - since > too_long)
    {
      hung = true;
      kill(process, SIGKILL);
    }
  }
  return { WIFEXITED(status) && WEXITSTATUS(status) == 0, hung, used.ru_maxrss };
}

/// A process takes them one after another; where a file ends it, another goes on behind that file.
Tally tally_of(const Input& input)
{
  void* const shared =
    mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  auto& progress = *new (shared) Progress;
  Tally tally;
  while (progress.next < input.count)
  {
    const pid_t process = fork();
    if (process == 0)
      take_all(input, progress);
    const Ending ending = watch(process, progress);
    tally.memory = std::max(tally.memory, ending.memory);
    tally.large += ending.memory > too_much;
    if (ending.whole)
      continue;
    ++(ending.hung ? tally.hangs : tally.crashes);
    std::cerr << input.target << ", damage " << first_damage + progress.next
              << (ending.hung ? ": hangs\n" : ": crashes\n");
    ++progress.next;
  }
  tally.taken = progress.next;
  tally.wrong = progress.wrong;
  munmap(shared, sizeof(Progress));
  return tally;
}

}

TEST(DamagedInputsLong, NoneCrashesHangsFillsTheMemoryOrIsWronglyAccepted)
{
  for (const Input& input : inputs)
  {
    const Tally tally = tally_of(input);
    std::cout << tally.taken << " damaged " << input.target << ": " << tally.crashes << " crashes, "
              << tally.hangs << " took 10 s, " << tally.large
              << " took 2 GB (most: " << tally.memory / 1000 << " MB), " << tally.wrong
              << " wrongly accepted\n";
    EXPECT_EQ(tally.taken, input.count);
    EXPECT_EQ(tally.crashes + tally.hangs + tally.large + tally.wrong, 0) << input.target;
  }
}

}
