#include "render/ColorScale.h"

#include "render/SurfaceMeasures.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"

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
constexpr double both_signs = 0.25;

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
  Range r = widened({ percentile(low_percentile), percentile(high_percentile) });
  if (r[0] < 0 && r[1] > 0 && std::min(-r[0], r[1]) > both_signs * std::max(-r[0], r[1]))
  {
    const double largest = std::max(-r[0], r[1]);
    r = { -largest, largest };
  }
  return r;
}

void fill_color_table(vtkLookupTable* table, ColorMap map, const Range& range)
{
  constexpr int colors = 256;
  vtkNew<vtkColorTransferFunction> function;
  if (map == ColorMap::diverging)
  {
    // Moreland's cool to warm: equal steps in lightness to both sides of grey.
    function->SetColorSpaceToDiverging();
    function->AddRGBPoint(0, 0.230, 0.299, 0.754);
    function->AddRGBPoint(1, 0.706, 0.016, 0.150);
  }
  else
  {
    // Support points of matplotlib's viridis.
    constexpr double viridis[][3] = { { 0.267, 0.005, 0.329 }, { 0.275, 0.195, 0.496 },
      { 0.213, 0.359, 0.552 }, { 0.153, 0.497, 0.558 }, { 0.122, 0.633, 0.531 },
      { 0.290, 0.759, 0.428 }, { 0.622, 0.854, 0.226 }, { 0.993, 0.906, 0.144 } };
    function->SetColorSpaceToLab();
    for (int i = 0; i < 8; ++i)
    {
      function->AddRGBPoint(i / 7., viridis[i][0], viridis[i][1], viridis[i][2]);
    }
  }
  table->SetNumberOfTableValues(colors);
  for (int i = 0; i < colors; ++i)
  {
    const double* c = function->GetColor(i / (colors - 1.));
    table->SetTableValue(i, c[0], c[1], c[2]);
  }
  table->SetTableRange(range[0], range[1]);
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
    if (std::abs(s - std::round(s)) < 1e-3 * s && s > 0.5)
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
