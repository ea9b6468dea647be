#include "tests/faults/FaultRuns.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>

namespace vesicle::test
{
namespace
{

using std::filesystem::path;

/// The environment of programs started meanwhile.
class FaultyDisk
{
public:
  FaultyDisk(const path& folder, const path& counter, const Fault& fault,
    const std::string& preloaded, std::chrono::microseconds delay)
    : counter_(counter)
  {
    std::ofstream(counter, std::ios::binary) << std::string(8, '\0');
    setenv("LD_PRELOAD", preloaded.c_str(), 1);
    setenv("FAULTY_FOLDER", folder.c_str(), 1);
    setenv("FAULTY_COUNTER", counter.c_str(), 1);
    setenv("FAULTY_CALL", std::to_string(fault.call).c_str(), 1);
    setenv("FAULTY_KIND", fault.kind.c_str(), 1);
    setenv("FAULTY_LASTING", fault.lasting ? "1" : "0", 1);
    setenv("FAULTY_DELAY", std::to_string(delay.count()).c_str(), 1);
  }
  ~FaultyDisk()
  {
    for (const char* name : { "LD_PRELOAD", "FAULTY_FOLDER", "FAULTY_COUNTER", "FAULTY_CALL",
           "FAULTY_KIND", "FAULTY_LASTING", "FAULTY_DELAY" })
    {
      unsetenv(name);
    }
  }
  FaultyDisk(const FaultyDisk&) = delete;
  FaultyDisk& operator=(const FaultyDisk&) = delete;

  std::int64_t calls() const
  {
    const std::string bytes = bytes_of(counter_);
    std::int64_t calls = 0;
    std::memcpy(&calls, bytes.data(), sizeof calls);
    return calls;
  }

private:
  path counter_;
};

std::string without_times(const std::string& summary)
{
  auto json = nlohmann::json::parse(summary, nullptr, false);
  if (json.is_object())
  {
    json.erase("timings");
  }
  return json.is_discarded() ? summary : json.dump();
}

}

const std::vector<Fault>& kinds_of_faults()
{
  static const std::vector<Fault> kinds{ { 0, "ENOSPC", true }, { 0, "ENOSPC", false },
    { 0, "EIO", true }, { 0, "EIO", false }, { 0, "EDQUOT", true }, { 0, "short", false },
    { 0, "kill", false } };
  return kinds;
}

Files files_in(const path& folder)
{
  Files files;
  std::error_code none;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, none))
  {
    // What is left of a lock locks nothing.
    if (entry.is_regular_file() && entry.path().filename() != "vesicle.lock")
    {
      const auto name = std::filesystem::relative(entry.path(), folder).string();
      const auto bytes = bytes_of(entry.path());
      files[name] = name == "summary.json" ? without_times(bytes) : bytes;
    }
  }
  return files;
}

std::vector<std::string> differences(const Files& a, const Files& b)
{
  std::vector<std::string> names;
  for (const auto& [name, bytes] : a)
  {
    const auto found = b.find(name);
    if (found == b.end() || found->second != bytes)
    {
      names.push_back(name);
    }
  }
  for (const auto& [name, bytes] : b)
  {
    if (!a.contains(name))
    {
      names.push_back(name);
    }
  }
  return names;
}

std::string text_of(const Tally& t)
{
  return fmt::format(
    "{} faults: {} that the run survived, {} failed resumes, {} differing results, "
    "{} crashes, {} without a message",
    t.faults, t.survived, t.failed_resumes, t.differing, t.crashes, t.unexplained);
}

FaultRuns::FaultRuns(std::vector<std::string> extra)
  : extra_(std::move(extra)), preloaded_(FAULTY_DISK)
{
  write_scene_file(folder_.path());
  const auto outcome = run("undisturbed", {});
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  undisturbed_ = files_in(folder_ / "undisturbed");
  calls_ = last_calls_;
}

void FaultRuns::set_clock_back()
{
  preloaded_ += ":" BACKWARD_CLOCK;
}

Outcome FaultRuns::run(
  const std::string& output, const Fault& fault, const std::vector<std::string>& more)
{
  std::vector<std::string> words{ "run", "pear.toml", "-o", output, "--threads", "1", "--set",
    "accuracy.preset=fast", "--set", "time.end=0.03", "--set", "time.output_every=0.02" };
  words.insert(words.end(), extra_.begin(), extra_.end());
  words.insert(words.end(), more.begin(), more.end());
  const FaultyDisk disk(folder_ / output, folder_ / "counter", fault, preloaded_, delay_);
  const auto outcome = vesicle_command(folder_.path(), words);
  last_calls_ = disk.calls();
  return outcome;
}

std::string FaultRuns::fault_text(const Fault& fault, const Outcome& outcome) const
{
  return fmt::format("{}{} at call {} of {}, exit code {}: {}", fault.lasting ? "lasting " : "",
    fault.kind, fault.call, calls_, outcome.code, outcome.errors);
}

void FaultRuns::expect_told(const Fault& fault, const Outcome& outcome)
{
  const std::string text = fault_text(fault, outcome);
  if (fault.kind == "kill")
  {
    EXPECT_TRUE(outcome.code == 128 + SIGKILL || outcome.code == 0 || outcome.code == 4) << text;
    return;
  }
  const bool told = outcome.code == 4 && outcome.errors.find("faulty") != std::string::npos;
  tally_.crashes += outcome.code > 128;
  tally_.unexplained += !told && outcome.code != 0;
  EXPECT_TRUE(told || outcome.code == 0) << text;
}

void FaultRuns::expect_nothing_lost(const Fault& fault, const std::string& from)
{
  ++tally_.faults;
  const auto folder = folder_ / "faulty";
  std::filesystem::remove_all(folder);
  std::vector<std::string> way;
  if (!from.empty())
  {
    std::filesystem::copy(folder_ / from, folder, std::filesystem::copy_options::recursive);
    way.emplace_back("--resume");
  }
  const auto broken = run("faulty", fault, way);
  const std::string text = fault_text(fault, broken);
  expect_told(fault, broken);
  if (broken.code == 0)
  {
    ++tally_.survived;
    const auto differing = differences(files_in(folder), undisturbed_);
    tally_.differing += !differing.empty();
    EXPECT_EQ(differing, std::vector<std::string>{}) << text;
  }
  const auto resumed = run("faulty", {}, { "--resume" });
  tally_.failed_resumes += resumed.code != 0;
  ASSERT_EQ(resumed.code, 0) << text << "resumed: " << resumed.errors;
  const auto differing = differences(files_in(folder), undisturbed_);
  tally_.differing += !differing.empty();
  EXPECT_EQ(differing, std::vector<std::string>{}) << text;
}

}
