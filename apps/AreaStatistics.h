#pragma once
// How the values of a quantity are distributed over a surface, each counting by its area.

#include <array>
#include <vector>

namespace vesicle
{

struct AreaStatistics
{
  static constexpr std::array percents{ 1, 5, 25, 50, 75, 95, 99 };

  double area = 0; ///< of all values; the rest means nothing where it is 0
  double mean = 0, deviation = 0;
  double least = 0, greatest = 0;
  /// Of `percents`: the smallest value up to which so much of the area lies.
  std::array<double, percents.size()> percentiles{};

  struct Bin
  {
    double from, to; ///< values from ≤ x < to; the last one x ≤ to
    double share;    ///< of the area
  };
  /// Of equal width, between the outermost percentiles; what lies beyond is in the first and in the
  /// last one, which go to the least and the greatest value.
  std::vector<Bin> bins;
};

/// A value and an area > 0 a vertex, say. `bins` ≥ 2; there is one where all values are the same.
AreaStatistics area_statistics(
  const std::vector<double>& values, const std::vector<double>& areas, int bins);

}
