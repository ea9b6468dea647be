#include "solver/flow/FlowHistory.h"

#include <algorithm>
#include <cmath>

namespace vesicle
{
namespace
{

// Times nearer than this share of them are the same: a corner that a run has hit may differ from the
// table's by rounding, and what comes after it counts.
constexpr double slack = 1e-10;

double later(double time)
{
  return time + slack * std::abs(time);
}

double along(const std::vector<std::array<double, 2>>& table, double time)
{
  const auto after = std::upper_bound(table.begin(), table.end(), time,
    [](double t, const std::array<double, 2>& row) { return t < row[0]; });
  if (after == table.begin())
    return table.front()[1];
  const auto& [start, from] = *(after - 1);
  if (after == table.end())
    return from;
  const auto& [end, to] = *after;
  return from + (to - from) * std::clamp((time - start) / (end - start), 0., 1.);
}

}

double FlowHistory::factor(double time) const
{
  const double wave = angular_frequency == 0 ? 1 : std::cos(angular_frequency * time);
  if (table.empty())
    return wave;
  const double now = later(time);
  const double turns = period ? std::floor(now / *period) : 0;
  return wave * along(table, period ? now - turns * *period : now);
}

double FlowHistory::largest() const
{
  double largest = table.empty() ? 1 : 0;
  for (const auto& row : table)
    largest = std::max(largest, std::abs(row[1]));
  return largest;
}

std::optional<double> FlowHistory::next_corner(double time) const
{
  const double now = later(time);
  const double first_turn = period ? std::floor(now / *period) : 0;
  // The end of a period is the start of the next one.
  for (double turn = first_turn; turn <= first_turn + (period ? 1 : 0); ++turn)
  {
    const double start = period ? turn * *period : 0;
    if (start > now)
      return start;
    for (const auto& row : table)
      if (start + row[0] > now)
        return start + row[0];
  }
  return {};
}

bool FlowHistory::settled(double time) const
{
  return !recurs() && !next_corner(time);
}

FlowHistory FlowHistory::in_units_of(double time) const
{
  FlowHistory scaled = *this;
  for (auto& row : scaled.table)
    row[0] /= time;
  if (scaled.period)
    *scaled.period /= time;
  scaled.angular_frequency *= time;
  return scaled;
}

}
