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

TEST(RangeFinder, IsSymmetricOnlyWhereBothSignsMatter)
{
  const Range both = range_of(evenly(-1, 2));
  EXPECT_EQ(both[0], -both[1]);
  const Range nearly_positive = range_of(evenly(-0.1, 2));
  EXPECT_NEAR(nearly_positive[0], -0.1, 0.02);
  EXPECT_NEAR(range_of(evenly(1, 2))[0], 1, 0.01);
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
}

TEST(ArrayTitle, IsReadable)
{
  EXPECT_EQ(array_title("Mean_Curvature", false), "Mean curvature H");
  EXPECT_EQ(array_title("Tension_Force", true), "Tension force (magnitude)");
}
