#include "apps/Progress.h"
#include "apps/StandardOutput.h"

#include "solver/dynamics/Diagnostics.h"
#include "solver/state/RunRows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <unistd.h>

namespace vesicle
{
namespace
{

// A terminal is refreshed as fast as one can read, a log gets a line every ten seconds.
constexpr std::chrono::milliseconds terminal_interval{ 200 };
constexpr std::chrono::seconds log_interval{ 10 };

double length(const std::array<double, 3>& v)
{
  return std::hypot(v[0], v[1], v[2]);
}

}

std::string duration_text(double seconds)
{
  const long whole = std::lround(std::max(seconds, 0.0));
  if (whole < 60)
  {
    return fmt::format("{} s", whole);
  }
  return whole < 3600 ? fmt::format("{} min {:02} s", whole / 60, whole % 60)
                      : fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

Progress::Progress(bool quiet, double start, std::optional<double> end)
  : quiet_(quiet), terminal_(isatty(STDOUT_FILENO)), start_(start), end_(end), began_(Clock::now())
{
}

Progress::~Progress()
{
  end_line();
}

std::string Progress::remaining(double time) const
{
  if (!end_ || !(time > start_))
  {
    return "";
  }
  const std::chrono::duration<double> spent = Clock::now() - began_;
  return ", " + duration_text(spent.count() * (*end_ - time) / (time - start_)) + " left";
}

void Progress::step(const std::vector<Diagnostics>& vesicles)
{
  const Diagnostics& d = vesicles.front();
  const auto now = Clock::now();
  const auto interval = terminal_ ? terminal_interval : std::chrono::milliseconds(log_interval);
  if (quiet_ || (last_shown_ && now - *last_shown_ < interval))
  {
    return;
  }
  last_shown_ = now;
  const std::string what = vesicles.size() > 1
    ? fmt::format("{} vesicles", vesicles.size())
    : fmt::format("U = {:.4g}, E/8piEB = {:.5f}", length(d.velocity), d.energy_over_8pi);
  overwrite(
    fmt::format("step {}, t = {:.5g}{}, dt = {:.2g}, {}, area drift {:.0e}, volume drift {:.0e}{}",
      d.step, d.time, end_ ? fmt::format(" of {:.5g}", *end_) : "", d.dt, what,
      largest(vesicles, &Diagnostics::area_drift), largest(vesicles, &Diagnostics::volume_drift),
      remaining(d.time)));
}

void Progress::count(const std::string& what, int done, int total)
{
  if (!quiet_ && (terminal_ || done == total))
  {
    overwrite(fmt::format("{} {}/{}", what, done, total));
  }
}

void Progress::say(const std::string& text)
{
  if (quiet_)
  {
    return;
  }
  end_line();
  print("{}\n", text);
  flush_standard_output();
}

void Progress::overwrite(const std::string& line)
{
  if (!terminal_)
  {
    print("{}\n", line);
  }
  else
  {
    print("\r{}\x1b[K", line); // to the line's start, and clear what is left of the old one
    line_open_ = true;
  }
  flush_standard_output();
}

void Progress::end_line()
{
  if (line_open_)
  {
    print("\n");
    line_open_ = false;
  }
}

}
