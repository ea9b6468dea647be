#pragma once
// Values to colours: the range over a whole series, the colour map, ticks and titles.

#include <array>
#include <string>
#include <vector>

class vtkDataArray;
class vtkLookupTable;

namespace vesicle
{

using Range = std::array<double, 2>;

/// Gathers the values of all frames and gives the range between two percentiles, so that a few
/// outliers (five-valent vertices, the start of a run) don't wash out the picture.
class RangeFinder
{
public:
  /// At most a few thousand values of the array, evenly spaced, count.
  void include(vtkDataArray* array);

  /// Symmetric about zero where both signs matter; never narrower than rounding errors.
  Range range() const;

  /// The value that this share (0 to 1) of all values lies below; 0 when there is none.
  double percentile(double share) const;

private:
  std::vector<double> values_;
};

/// Cool to warm (blue, grey, red) for signed quantities, dark to bright for magnitudes.
enum class ColorMap
{
  diverging,
  sequential
};
void fill_color_table(vtkLookupTable* table, ColorMap map, const Range& range);

/// About `count` round numbers within the range.
std::vector<double> round_ticks(const Range& range, int count);

/// printf format that tells neighbouring values apart, e.g. "%.2f".
std::string number_format(const std::vector<double>& values);

/// What the colour bar says: "Mean curvature H" for Mean_Curvature, "Velocity (magnitude)" for a
/// vector.
std::string array_title(const std::string& array, bool vector);

}
