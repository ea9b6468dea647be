#pragma once
// Values to colours: the range over a whole series, the colour map, ticks and titles.

#include "render/ColorMap.h"

#include <array>
#include <string>
#include <vector>

class vtkDataArray;
class vtkLookupTable;
class vtkPolyData;

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

  /// Never narrower than rounding errors.
  Range range() const;

  /// The value that this share (0 to 1) of all values lies below; 0 when there is none.
  double percentile(double share) const;

private:
  std::vector<double> values_;
};

/// Which colour a value has. Diverging: the map's middle is at `center`, and values equally far
/// from it on both sides are equally strong; sequential: from the range's low end to its high end.
struct ColorScale
{
  ColorMap map = ColorMap::sequential;
  Range range{ 0, 1 };
  double center = 0;
};

/// Diverging where the range holds values on both sides of the neutral one (about zero: where the
/// weaker sign matters), sequential otherwise and for the magnitudes of vectors.
ColorScale choose_color_scale(const Range& range, double neutral, bool vector);

/// The value that neither colour should have: of the mean curvature that of the sphere of the same
/// volume, 1/r0 (the mean one of several vesicles), so that red is more curved and blue flatter than it; 0 of everything else.
double neutral_value(const std::string& array, vtkPolyData* surface);

/// The colours of the range, from its low end to its high one.
std::vector<Color> colors_of_range(const ColorScale& scale, int count);
void fill_color_table(vtkLookupTable* table, const ColorScale& scale);

/// About `count` round numbers within the range.
std::vector<double> round_ticks(const Range& range, int count);

/// printf format that tells neighbouring values apart, e.g. "%.2f".
std::string number_format(const std::vector<double>& values);

/// What the colour bar says: "Mean curvature H" for Mean_Curvature, "Velocity (magnitude)" for a
/// vector.
std::string array_title(const std::string& array, bool vector);

}
