#include "render/ColorScale.h"

#include "render/SurfaceMeasures.h"

#include "vtkDataArray.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

namespace vesicle
{
namespace
{

constexpr vtkIdType values_per_frame = 4096; // 1,000 frames then take 32 MB
constexpr double low_percentile = 0.005;
constexpr double high_percentile = 0.995;

/// Both signs matter when the weaker one reaches this share of the stronger.
constexpr double both_signs = 0.15;

/// A range narrower than this share of its values is noise about a constant (a sphere's H).
constexpr double least_relative_width = 1e-3;
constexpr double width_about_a_constant = 0.1;

Range widened(Range r)
{
  const double largest = std::max(std::abs(r[0]), std::abs(r[1]));
  if (largest == 0)
  {
    return { -1, 1 };
  }
  if (r[1] - r[0] < least_relative_width * largest)
  {
    const double middle = 0.5 * (r[0] + r[1]);
    return { middle - width_about_a_constant * largest, middle + width_about_a_constant * largest };
  }
  return r;
}

/// 1, 2, 2.5 or 5 times a power of ten, the nearest above `step`.
double round_step(double step)
{
  const double power = std::pow(10, std::floor(std::log10(step)));
  for (const double digit : { 1., 2., 2.5, 5. })
  {
    if (digit * power >= step * (1 - 1e-9))
    {
      return digit * power;
    }
  }
  return 10 * power;
}

}

void RangeFinder::include(vtkDataArray* array)
{
  const vtkIdType count = array->GetNumberOfTuples();
  const vtkIdType stride = std::max<vtkIdType>(1, count / values_per_frame);
  for (vtkIdType i = 0; i < count; i += stride)
  {
    values_.push_back(scalar_value(array, i));
  }
}

double RangeFinder::percentile(double share) const
{
  if (values_.empty())
  {
    return 0;
  }
  auto sorted = values_;
  const auto nth = sorted.begin() + std::lround(share * static_cast<double>(sorted.size() - 1));
  std::nth_element(sorted.begin(), nth, sorted.end());
  return *nth;
}

Range RangeFinder::range() const
{
  return widened({ percentile(low_percentile), percentile(high_percentile) });
}

ColorScale choose_color_scale(const Range& range, double neutral, bool vector)
{
  const double below = neutral - range[0];
  const double above = range[1] - neutral;
  const double least = neutral == 0 ? both_signs * std::max(below, above) : 0;
  const bool diverging = !vector && std::min(below, above) > least;
  return { diverging ? ColorMap::diverging : ColorMap::sequential, range, neutral };
}

double neutral_value(const std::string& array, vtkPolyData* surface)
{
  vtkDataArray* ids = surface->GetPointData()->GetArray("Vesicle_Id");
  const double vesicles = ids ? ids->GetRange()[1] + 1 : 1;
  const double volume = array == "Mean_Curvature" ? enclosed_volume(surface) / vesicles : 0;
  return volume > 0 ? std::cbrt(4 * vtkMath::Pi() / (3 * volume)) : 0;
}

std::vector<Color> colors_of_range(const ColorScale& scale, int count)
{
  if (scale.map == ColorMap::sequential)
  {
    return color_table(scale.map, count);
  }
  constexpr int fine = 2049; // many more than any range is cut into
  const auto all = color_table(scale.map, fine);
  const double reach = std::max(scale.center - scale.range[0], scale.range[1] - scale.center);
  std::vector<Color> colors;
  for (int i = 0; i < count; ++i)
  {
    const double value = scale.range[0] + (scale.range[1] - scale.range[0]) * i / (count - 1);
    const double share = 0.5 + 0.5 * std::clamp((value - scale.center) / reach, -1., 1.);
    colors.push_back(all[static_cast<std::size_t>(std::lround(share * (fine - 1)))]);
  }
  return colors;
}

void fill_color_table(vtkLookupTable* table, const ColorScale& scale)
{
  constexpr int count = 256;
  const auto colors = colors_of_range(scale, count);
  table->SetNumberOfTableValues(count);
  for (int i = 0; i < count; ++i)
  {
    const Color& c = colors[static_cast<std::size_t>(i)];
    table->SetTableValue(i, c[0], c[1], c[2]);
  }
  table->SetTableRange(scale.range[0], scale.range[1]);
}

std::vector<double> round_ticks(const Range& range, int count)
{
  const double step = round_step((range[1] - range[0]) / count);
  constexpr double slack = 1e-6;
  const double first = std::ceil(range[0] / step - slack);
  const double last = std::floor(range[1] / step + slack);
  std::vector<double> ticks;
  for (double k = first; k <= last; ++k)
  {
    ticks.push_back(k * step + 0.0); // + 0 turns −0 into 0
  }
  return ticks;
}

std::string number_format(const std::vector<double>& values)
{
  double largest = 0;
  double step = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    largest = std::max(largest, std::abs(values[i]));
    const double gap = i > 0 ? std::abs(values[i] - values[i - 1]) : 0;
    step = gap > 0 && (step == 0 || gap < step) ? gap : step;
  }
  step = step > 0 ? step : std::max(largest, 1.) / 100;
  constexpr double shortest = 1e-3;
  constexpr double longest = 1e5;
  constexpr int most_digits = 6;
  const bool plain = largest == 0 || (largest >= shortest && largest < longest);
  const double unit = plain ? 1 : std::pow(10, std::floor(std::log10(largest)));
  int digits = 0;
  for (double s = step / unit; digits < most_digits; ++digits, s *= 10)
  {
    const double shown = std::pow(10, digits) / unit; // values in the last digit
    if (s > 0.5 &&
      std::all_of(values.begin(), values.end(),
        [&](double v) { return std::abs(v * shown - std::round(v * shown)) < 1e-3 * s; }))
    {
      break;
    }
    if (s >= 10) // an uneven step: two digits of it are enough
    {
      break;
    }
  }
  return fmt::format("%.{}{}", digits, plain ? 'f' : 'e');
}

std::string array_title(const std::string& array, bool vector)
{
  static const std::map<std::string, std::string> symbols{ { "Mean_Curvature", " H" },
    { "Gauss_Curvature", " K" } };
  std::string title = array;
  for (std::size_t i = 0; i < title.size(); ++i)
  {
    const bool word_of_its_own = i + 1 == title.size() || title[i + 1] == '_';
    if (title[i] == '_')
    {
      title[i] = ' ';
    }
    else if (i > 0 && title[i - 1] == ' ' && !word_of_its_own)
    {
      title[i] = static_cast<char>(std::tolower(static_cast<unsigned char>(title[i])));
    }
  }
  const auto symbol = symbols.find(array);
  title += symbol == symbols.end() ? "" : symbol->second;
  return vector ? title + " (magnitude)" : title;
}

}
