// The chart beside a movie: what has passed, and now.

#include "render/SideChart.h"

#include <gtest/gtest.h>

using namespace vesicle;

namespace
{

ChartSpec course()
{
  ChartSpec chart;
  chart.lines.push_back({ "height", { 0, 1, 2 }, { 0, 10, 40 } });
  return chart;
}

}

TEST(SideChart, PassedIsCutAtNow)
{
  const ChartSpec now = chart_at(course(), 1.5);
  ASSERT_EQ(now.lines.size(), 3u); // whole, passed, point
  EXPECT_EQ(now.lines[0].x, (std::vector{ 0., 1., 2. }));
  EXPECT_EQ(now.lines[0].label, "");
  EXPECT_EQ(now.lines[1].x, (std::vector{ 0., 1., 1.5 }));
  EXPECT_EQ(now.lines[1].y, (std::vector{ 0., 10., 25. })); // halfway
  EXPECT_EQ(now.lines[1].label, "height");
  EXPECT_EQ(now.lines[2].x, (std::vector{ 1.5 }));
  EXPECT_EQ(now.lines[2].style, ChartLine::Style::points);
}

TEST(SideChart, TheEndsAreTheTableS)
{
  EXPECT_EQ(chart_at(course(), 0).lines.size(), 2u); // a single point is no line
  EXPECT_EQ(chart_at(course(), -1).lines.size(), 1u);
  const ChartSpec end = chart_at(course(), 3);
  EXPECT_EQ(end.lines[1].x, (std::vector{ 0., 1., 2. }));
  EXPECT_EQ(end.lines[2].y, (std::vector{ 40. }));
}
