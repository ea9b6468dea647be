#pragma once
// How far a run has come, for whoever watches.

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vesicle
{

struct Diagnostics;

/// One line that is written over on a terminal; in a log a plain line now and then.
class Progress
{
public:
  /// `end` is the run's last time (empty: unknown), `start` where it starts or goes on.
  Progress(bool quiet, double start, std::optional<double> end);
  ~Progress();

  /// Of each vesicle.
  void step(const std::vector<Diagnostics>& vesicles);
  /// A line of its own.
  void say(const std::string& text);
  /// "what 3/20", written over on a terminal; in a log only the last.
  void count(const std::string& what, int done, int total);

private:
  using Clock = std::chrono::steady_clock;

  std::string remaining(double time) const;
  void overwrite(const std::string& line);
  void end_line();

  bool quiet_;
  bool terminal_;
  bool line_open_ = false;
  double start_;
  std::optional<double> end_;
  Clock::time_point began_;
  std::optional<Clock::time_point> last_shown_;
};

/// "45 s", "3 min 20 s", "2 h 05 min".
std::string duration_text(double seconds);

}
