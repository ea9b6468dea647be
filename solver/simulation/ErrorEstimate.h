#pragma once
// What a run can tell of its own errors, without another run beside it.

#include <optional>
#include <string>

namespace vesicle
{

/// Relative, all of them, and each a measure of an error's size, not a bound.
struct ErrorEstimate
{
  /// |E6/E12 − 1|, the bending energy of Loop's surface by 6 and by 12 points a triangle; of flat
  /// triangles |E/E12 − 1|, their own beside that of Loop's surface through their vertices. Empty without
  /// bending.
  std::optional<double> energy;
  /// |E3/E12 − 1|, which tells when a shape is about to be lost; smooth surfaces only.
  std::optional<double> energy_coarse;
  /// Change of the velocity by the next finer rule of the single layer, root mean square over the vertices,
  /// relative to that of the velocity or, at rest, to r0 times the system's rate.
  double layer = 0;
  /// What projections have taken out of area and volume so far, and what they left: the error in time
  /// that doesn't show in area and volume themselves.
  double time = 0;

  /// The larger of energy and layer.
  double space() const;
};

/// One line.
std::string to_text(const ErrorEstimate& estimate);

}
