// Charts: not blank, the right size, and errors for what can't be drawn.

#include "TestSurfaces.h"

#include "render/Chart.h"
#include "solver/Errors.h"
#include "vtkfilters/Filters/VtkMessages.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <limits>

using namespace vesicle;
using namespace vesicle::test;

namespace
{

ChartSpec parabola()
{
  ChartLine line{ "t squared", {}, {}, ChartLine::Style::line };
  for (int i = 0; i < 50; ++i)
  {
    line.x.push_back(0.1 * i);
    line.y.push_back(0.01 * i * i);
  }
  ChartSpec chart{ "A parabola", "t", "y", { line, line }, false, false };
  chart.lines[1].label = "samples";
  chart.lines[1].style = ChartLine::Style::points;
  return chart;
}

vtkSmartPointer<vtkImageData> drawn(const ChartSpec& chart)
{
  const TemporaryFolder folder;
  write_chart(folder / "chart.png", chart, { 640, 360 });
  return read_png(folder / "chart.png");
}

}

TEST(Chart, IsNotBlank)
{
  const auto image = drawn(parabola());
  EXPECT_EQ(size_of(image), (std::array{ 640, 360 }));
  const auto colors = colors_of(image);
  EXPECT_TRUE(colors.contains({ 255, 255, 255 }));
  EXPECT_TRUE(colors.contains({ 0, 114, 178 })); // the first line's colour
  EXPECT_TRUE(colors.contains({ 213, 94, 0 }));  // the second's
}

TEST(Chart, LeavesOutWhatIsNotFinite)
{
  ChartSpec chart = parabola();
  const auto before = drawn(chart);
  chart.lines[0].x.push_back(2);
  chart.lines[0].y.push_back(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(difference(before, drawn(chart)), 0);
}

TEST(Chart, DrawsALineWhateverItsLabel)
{
  for (const char* label : { "x", "y", "abscissa", "ordinate", "t", "", " ", "100 % \xc3\xa9",
         "a label\nof two lines", "x,y;\"z\"" })
  {
    SCOPED_TRACE(label);
    ChartSpec chart = parabola();
    chart.lines[0].label = label;
    const auto colors = colors_of(drawn(chart));
    EXPECT_TRUE(colors.contains({ 0, 114, 178 }));
    EXPECT_TRUE(colors.contains({ 213, 94, 0 }));
  }
}

TEST(Chart, ShowsEachLinesLabelInTheLegend)
{
  ChartSpec chart = parabola();
  chart.lines[0].label = chart.lines[1].label = "same"; // stands there twice
  const auto twice = drawn(chart);
  chart.lines[1].label.clear();
  const auto once = drawn(chart);
  chart.lines[0].label = std::string("x");
  const auto other = drawn(chart);
  chart.lines[0].label.clear();
  const auto none = drawn(chart);
  EXPECT_GT(difference(twice, once), 0);
  EXPECT_GT(difference(once, other), 0);
  EXPECT_GT(difference(other, none), 0.01); // the legend's room goes to the axes
}

// VTK complains of lines of one point and draws nothing.
TEST(Chart, ALineOfOnePointIsAPoint)
{
  ChartSpec chart = parabola();
  chart.lines[0].x = { 1 };
  chart.lines[0].y = { 1 };
  const VtkMessages messages;
  EXPECT_TRUE(colors_of(drawn(chart)).contains({ 0, 114, 178 }));
  EXPECT_FALSE(messages.any_error());
}

TEST(Chart, LogarithmicAxesChangeThePicture)
{
  ChartSpec chart = parabola();
  const auto linear = drawn(chart);
  chart.log_x = chart.log_y = true;
  EXPECT_GT(difference(linear, drawn(chart)), 0.02);
}

TEST(Chart, SeveralFitIntoOnePicture)
{
  const TemporaryFolder folder;
  write_charts(folder / "charts.png", { parabola(), parabola(), parabola() }, 2, { 800, 600 });
  const auto image = read_png(folder / "charts.png");
  EXPECT_EQ(size_of(image), (std::array{ 800, 600 }));
  EXPECT_FALSE(colors_of(image).contains({ 0, 0, 0 })); // the fourth place is as white as the paper
}

TEST(Chart, IsAnSvgFileWhereItsNameEndsSo)
{
  const TemporaryFolder folder;
  ChartSpec chart = parabola();
  chart.lines[1].style = ChartLine::Style::cross;
  write_chart(folder / "chart.svg", chart, { 640, 360 });
  std::ifstream in(folder / "chart.svg");
  const std::string text(std::istreambuf_iterator<char>(in), {});
  EXPECT_EQ(text.find("<svg"), 0U);
  EXPECT_NE(text.find("width=\"640\""), std::string::npos);
  EXPECT_NE(text.find("</svg>"), std::string::npos);
  std::size_t marks = 0;
  for (auto at = text.find("<use"); at != std::string::npos; at = text.find("<use", at + 1))
    ++marks;
  EXPECT_GE(marks, chart.lines[1].x.size()); // and one in the legend
  EXPECT_THROW(write_chart("/nonexistent/chart.svg", chart), IoError);
}

TEST(Chart, RefusesWhatItCannotDraw)
{
  ChartSpec uneven = parabola();
  uneven.lines[0].y.pop_back();
  EXPECT_THROW(drawn(uneven), InputError);
  EXPECT_THROW(drawn(ChartSpec{}), InputError);
  EXPECT_THROW(write_chart("/nonexistent/chart.png", parabola()), IoError);
}
