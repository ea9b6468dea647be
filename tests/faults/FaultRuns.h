#pragma once
// Runs on a disk that fails, and what has to come of them.

#include "tests/apps/Command.h"

#include <chrono>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace vesicle::test
{

struct Fault
{
  std::int64_t call = 0; ///< from 1, in the order of FaultyDisk.cpp; 0: none
  std::string kind;      ///< of FaultyDisk.cpp
  bool lasting = false;
};

/// All kinds that a call is tried with.
const std::vector<Fault>& kinds_of_faults();

/// The files of a folder by their names in it, but for a lock's; of summary.json without the times.
using Files = std::map<std::string, std::string>;
Files files_in(const std::filesystem::path& folder);
/// The names of files that one has and the other hasn't, or not with these bytes.
std::vector<std::string> differences(const Files& a, const Files& b);

struct Tally
{
  int faults = 0, survived = 0, failed_resumes = 0, differing = 0, crashes = 0, unexplained = 0;
};
std::string text_of(const Tally& tally);

/// A scene, what an undisturbed run of it leaves, and the same run on failing disks.
class FaultRuns
{
public:
  /// `extra`: more arguments of `vesicle run`.
  explicit FaultRuns(std::vector<std::string> extra);

  std::int64_t calls() const { return calls_; }           ///< that an undisturbed run makes
  std::int64_t last_calls() const { return last_calls_; } ///< that the last run made
  const Files& undisturbed() const { return undisturbed_; }
  const std::filesystem::path& folder() const { return folder_.path(); }

  /// From now on runs find the wall clock an hour earlier each time they look.
  void set_clock_back();
  /// From now on runs have a disk that is behind them: each sync takes that long.
  void set_delay(std::chrono::microseconds delay) { delay_ = delay; }

  /// Makes a run with that fault, or goes on with a copy of the one in `from`; then goes on without
  /// the fault: expects an exit code and a message that tell what happened, then the same files as
  /// without the fault.
  void expect_nothing_lost(const Fault& fault, const std::string& from = {});
  const Tally& tally() const { return tally_; }

  /// The run in a folder of that name, on a failing disk or a sound one.
  Outcome run(
    const std::string& output, const Fault& fault, const std::vector<std::string>& more = {});

private:
  std::string fault_text(const Fault& fault, const Outcome& outcome) const;
  void expect_told(const Fault& fault, const Outcome& outcome);

  TemporaryFolder folder_;
  std::vector<std::string> extra_;
  std::string preloaded_; ///< libraries
  std::chrono::microseconds delay_{ 0 };
  Files undisturbed_;
  std::int64_t calls_ = 0, last_calls_ = 0;
  Tally tally_;
};

}
