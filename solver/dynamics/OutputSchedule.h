#pragma once
// The times that a run hits exactly.

#include "solver/dynamics/State.h"

#include <functional>
#include <optional>
#include <vector>

namespace vesicle
{

/// Times closer than 1e-10 of them are the same: output times are multiples of a decimal fraction,
/// which a caller may have rounded differently.
bool same_time(double a, double b);

/// Multiples of `every`, the end, and corners of what drives the run. Times are in the scene's units.
class OutputSchedule
{
public:
  /// The first corner after a time; empty: there is none.
  using Corners = std::function<std::optional<double>(double)>;

  /// `every` 0: no times but the end; `end` empty: until the run ends by itself. `corners`: further
  /// times that are hit, without an output.
  OutputSchedule(double every, std::optional<double> end, Corners corners = {});

  const std::optional<double>& end() const { return end_; }
  /// The output or end that the run goes to next; empty if there is none.
  std::optional<double> next(const State& state) const;
  /// The same or a corner that comes before it.
  std::optional<double> next_stop(const State& state) const;
  /// True at the start and where a multiple of `every` was hit.
  bool due(const State& state) const;
  /// The times of the outputs that `state` has passed, from the start on.
  std::vector<double> passed(const State& state) const;
  /// Counts the output on, if `state` has hit one.
  void pass(State& state) const;
  /// All times from `from` to `end`, with these two.
  std::vector<double> between(double from, double end) const;

private:
  double multiple(std::int64_t k) const;

  double every_;
  std::optional<double> end_;
  Corners corners_;
};

}
