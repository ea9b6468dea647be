#pragma once
// A run of the command `vesicle` as a process of its own.

#include <string>
#include <vector>

#include <sys/types.h>

namespace vesicle
{

/// The processors shared out among so many runs at a time, 1 at least.
int threads_a_run(int jobs);

class ChildRun
{
public:
  /// Starts this program with these arguments. The child is asked to end, which saves, if this process
  /// ends. Throws IoError.
  explicit ChildRun(const std::vector<std::string>& arguments);
  /// Asks a child that still runs to end, and waits for it.
  ~ChildRun();
  ChildRun(const ChildRun&) = delete;
  ChildRun& operator=(const ChildRun&) = delete;

  /// Whether it still runs.
  bool running();
  /// What it ended with: its exit code, or 128 + signal where a signal ended it.
  int code() const { return code_; }
  /// What it has printed, errors too.
  const std::string& output() const { return output_; }
  /// The last line of it, or what it ended with where it has printed nothing.
  std::string last_words() const;
  /// That it has taken so far; 0 once it has ended.
  double cpu_seconds() const;
  /// As Ctrl-C does.
  void interrupt() const;

private:
  void read_output();

  pid_t process_ = -1; ///< -1: has ended
  int pipe_ = -1;      ///< what it prints
  int code_ = 0;
  std::string output_;
};

}
