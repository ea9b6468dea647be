#pragma once
// How the strength of an imposed flow changes with time.

#include <array>
#include <optional>
#include <vector>

namespace vesicle
{

/// The factor of a flow: what a table of times says, times cos ωt. Plain data, in any consistent units.
struct FlowHistory
{
  /// Times, none earlier than the one before, and factors: linear between, constant before the first
  /// and after the last. Two rows of one time are a jump, of which the second counts from then on.
  /// Empty: 1.
  std::vector<std::array<double, 2>> table;
  std::optional<double> period; ///< the table, from 0 to here, again and again
  double angular_frequency = 0; ///< ω

  bool steady() const { return table.empty() && angular_frequency == 0; }
  double factor(double time) const;
  /// The largest |factor|, of any time.
  double largest() const;
  /// The first time after `time` where the table has a row; empty: there is none.
  std::optional<double> next_corner(double time) const;
  /// Whether the factor is the same from `time` on.
  bool settled(double time) const;
  /// Whether it goes on varying for ever.
  bool recurs() const { return period || angular_frequency != 0; }
  /// The same with times divided by `time`.
  FlowHistory in_units_of(double time) const;
};

}
