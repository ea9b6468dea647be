#include "solver/dynamics/OutputSchedule.h"

#include <algorithm>
#include <cmath>

namespace vesicle
{

bool same_time(double a, double b)
{
  constexpr double slack = 1e-10;
  return std::abs(a - b) <= slack * std::max(std::abs(a), std::abs(b));
}

OutputSchedule::OutputSchedule(double every, std::optional<double> end, Corners corners)
  : every_(every), end_(end), corners_(std::move(corners))
{
}

// k · every, without the rounding of decimal fractions where 1/every is a whole number.
double OutputSchedule::multiple(std::int64_t k) const
{
  const double inverse = std::round(1 / every_);
  return std::abs(inverse * every_ - 1) < 1e-12 ? static_cast<double>(k) / inverse
                                                : static_cast<double>(k) * every_;
}

std::optional<double> OutputSchedule::next(const State& state) const
{
  std::optional<double> next = end_;
  if (every_ > 0)
  {
    const double output = multiple(state.controller.output);
    next = next ? std::min(*next, output) : output;
  }
  return next;
}

std::optional<double> OutputSchedule::next_stop(const State& state) const
{
  const std::optional<double> output = next(state);
  const std::optional<double> corner = corners_ ? corners_(state.time) : std::nullopt;
  if (!corner || (output && (*output <= *corner || same_time(*output, *corner))))
    return output;
  return corner;
}

bool OutputSchedule::due(const State& state) const
{
  return state.step == 0 ||
    (every_ > 0 && same_time(state.time, multiple(state.controller.output - 1)));
}

std::vector<double> OutputSchedule::passed(const State& state) const
{
  std::vector<double> times;
  for (std::int64_t k = 0; k < state.controller.output; ++k)
    times.push_back(multiple(k));
  return times;
}

void OutputSchedule::pass(State& state) const
{
  if (every_ > 0 && state.time == multiple(state.controller.output))
    ++state.controller.output;
}

std::vector<double> OutputSchedule::between(double from, double end) const
{
  std::vector<double> times{ from };
  if (every_ > 0)
    for (auto k = static_cast<std::int64_t>(std::floor(from / every_)) + 1; multiple(k) < end; ++k)
      if (!same_time(multiple(k), end) && !same_time(multiple(k), from))
        times.push_back(multiple(k));
  if (end > from)
    times.push_back(end);
  return times;
}

}
