// Ranges, ticks and titles.

#include "TestSurfaces.h"

#include "render/ColorScale.h"

#include <gtest/gtest.h>

using namespace vesicle;
using namespace vesicle::test;

namespace
{

Range range_of(const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  RangeFinder finder;
  finder.include(array);
  return finder.range();
}

/// CIELAB by its definition, D65 white.
std::array<double, 3> lab(const Color& color)
{
  std::array<double, 3> linear, xyz, f;
  for (int i = 0; i < 3; ++i)
  {
    linear[i] = color[i] <= 0.04045 ? color[i] / 12.92 : std::pow((color[i] + 0.055) / 1.055, 2.4);
  }
  constexpr double matrix[3][3] = { { 0.4124564, 0.3575761, 0.1804375 },
    { 0.2126729, 0.7151522, 0.0721750 }, { 0.0193339, 0.1191920, 0.9503041 } };
  for (int i = 0; i < 3; ++i)
  {
    xyz[i] = (matrix[i][0] * linear[0] + matrix[i][1] * linear[1] + matrix[i][2] * linear[2]) /
      (matrix[i][0] + matrix[i][1] + matrix[i][2]);
    f[i] = xyz[i] > 216. / 24389 ? std::cbrt(xyz[i]) : (24389. / 27 * xyz[i] + 16) / 116;
  }
  return { 116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2]) };
}

double lightness(const Color& color)
{
  return lab(color)[0];
}

double distance(const Color& a, const Color& b)
{
  const auto p = lab(a), q = lab(b);
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

std::vector<double> evenly(double from, double to)
{
  std::vector<double> values;
  for (int i = 0; i <= 1000; ++i)
  {
    values.push_back(from + (to - from) * i / 1000);
  }
  return values;
}

}

TEST(RangeFinder, IgnoresOutliers)
{
  auto values = evenly(1, 2);
  values.push_back(1e6);
  EXPECT_NEAR(range_of(values)[1], 2, 0.01);
}

TEST(ColorScale, DivergesAboutTheNeutralValue)
{
  const ColorScale scale = choose_color_scale({ 0.5, 2 }, 1, false);
  EXPECT_EQ(scale.map, ColorMap::diverging);
  const auto colors = colors_of_range(scale, 151); // steps of 0.01
  const Color& middle = colors[50];
  for (const double c : middle)
  {
    EXPECT_GT(c, 0.9); // near white
  }
  EXPECT_GT(colors[0][2], colors[0][0]);     // blue below
  EXPECT_GT(colors[150][0], colors[150][2]); // red above
  // As far from neutral, about as light (4.5 of 100 is what blue and red differ by there).
  EXPECT_NEAR(lightness(colors[0]), lightness(colors[100]), 6);
  EXPECT_GT(lightness(colors[0]), lightness(colors[150]) + 15);
}

TEST(ColorScale, DivergesAboutZeroOnlyWhereBothSignsMatter)
{
  EXPECT_EQ(choose_color_scale({ -1, 2 }, 0, false).map, ColorMap::diverging);
  EXPECT_EQ(choose_color_scale({ -0.1, 2 }, 0, false).map, ColorMap::sequential);
  EXPECT_EQ(choose_color_scale({ 1, 2 }, 0, false).map, ColorMap::sequential);
  EXPECT_EQ(choose_color_scale({ 1, 2 }, 0.9, false).map, ColorMap::sequential);
  EXPECT_EQ(choose_color_scale({ -1, 2 }, 0, true).map, ColorMap::sequential);
}

TEST(ColorScale, ASphereIsNeutralInItsMeanCurvature)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(2);
  sphere->SetThetaResolution(100);
  sphere->SetPhiResolution(100);
  sphere->Update();
  EXPECT_NEAR(neutral_value("Mean_Curvature", sphere->GetOutput()), 0.5, 1e-3);
  EXPECT_EQ(neutral_value("Tension", sphere->GetOutput()), 0);
}

TEST(ColorMap, NeighboursDifferByTheSame)
{
  for (const ColorMap map : { ColorMap::diverging, ColorMap::sequential })
  {
    constexpr int count = 257;
    const auto colors = color_table(map, count);
    double shortest = 1e9, longest = 0;
    for (int i = 0; i + 1 < count; ++i)
    {
      const double step = distance(colors[i], colors[i + 1]);
      shortest = std::min(shortest, step);
      longest = std::max(longest, step);
    }
    // The diverging map's halves differ by 5% in length; corners of the path cut a few steps short.
    EXPECT_LT(longest / shortest, 1.15) << static_cast<int>(map);
  }
}

TEST(ColorMap, IsLightestInTheMiddleOrAtItsHighEnd)
{
  const auto diverging = color_table(ColorMap::diverging, 65);
  const auto sequential = color_table(ColorMap::sequential, 65);
  for (int i = 0; i < 32; ++i)
  {
    EXPECT_LT(lightness(diverging[i]), lightness(diverging[i + 1]));
    EXPECT_LT(lightness(diverging[64 - i]), lightness(diverging[63 - i]));
  }
  for (int i = 0; i < 64; ++i)
  {
    EXPECT_LT(lightness(sequential[i]), lightness(sequential[i + 1]));
  }
}

TEST(RangeFinder, DoesNotMagnifyRoundingErrors)
{
  const Range constant = range_of(evenly(1 - 1e-7, 1 + 1e-7));
  EXPECT_NEAR(constant[0], 0.9, 1e-3);
  EXPECT_NEAR(constant[1], 1.1, 1e-3);
  EXPECT_EQ(range_of({ 0, 0, 0 }), (Range{ -1, 1 }));
}

TEST(RoundTicks, AreRoundAndWithinTheRange)
{
  EXPECT_EQ(round_ticks({ 0.55, 3.3 }, 6), (std::vector{ 1., 1.5, 2., 2.5, 3. }));
  EXPECT_EQ(round_ticks({ -2, 2 }, 4), (std::vector{ -2., -1., 0., 1., 2. }));
}

TEST(NumberFormat, TellsNeighboursApart)
{
  EXPECT_EQ(number_format({ 0, 0.05, 0.1 }), "%.2f");
  EXPECT_EQ(number_format({ 0, 1, 2 }), "%.0f");
  EXPECT_EQ(number_format({ 1e6, 1.5e6, 2e6 }), "%.1e");
  EXPECT_EQ(number_format({ 11, 13, 14.5, 15.5 }), "%.1f");
  EXPECT_EQ(number_format({ 0.05, 0.15, 0.25 }), "%.2f");
}

TEST(ArrayTitle, IsReadable)
{
  EXPECT_EQ(array_title("Mean_Curvature", false), "Mean curvature H");
  EXPECT_EQ(array_title("Tension_Force", true), "Tension force (magnitude)");
}
