#include "render/SideChart.h"

#include "render/ChartItem.h"

#include "vtkChartXY.h"

#include <algorithm>

namespace vesicle
{
namespace
{

constexpr double paleness = 0.72;
constexpr double inset = 0.12;
constexpr double letters = 0.85; // of those of a chart that fills the picture

std::array<int, 3> pale(const std::array<int, 3>& color)
{
  std::array<int, 3> result;
  for (int i = 0; i < 3; ++i)
  {
    result[i] = static_cast<int>(color[i] + paleness * (255 - color[i]));
  }
  return result;
}

/// The line up to `time`, its last point there by linear interpolation.
ChartLine until(const ChartLine& line, double time)
{
  ChartLine past = line;
  const auto count =
    static_cast<std::size_t>(std::upper_bound(line.x.begin(), line.x.end(), time) - line.x.begin());
  past.x.resize(count);
  past.y.resize(count);
  if (count > 0 && count < line.x.size() && time > line.x[count - 1])
  {
    const double t = (time - line.x[count - 1]) / (line.x[count] - line.x[count - 1]);
    past.x.push_back(time);
    past.y.push_back((1 - t) * line.y[count - 1] + t * line.y[count]);
  }
  return past;
}

}

ChartSpec chart_at(const ChartSpec& chart, double time)
{
  ChartSpec now = chart;
  now.lines.clear();
  std::vector<ChartLine> passed, points;
  for (std::size_t i = 0; i < chart.lines.size(); ++i)
  {
    const auto color = chart.lines[i].color.value_or(chart_color(i));
    ChartLine whole = chart.lines[i];
    ChartLine past = until(whole, time);
    whole.color = pale(color);
    whole.label.clear();
    past.color = color;
    now.lines.push_back(std::move(whole));
    if (!past.x.empty())
    {
      ChartLine point{ "", { past.x.back() }, { past.y.back() }, ChartLine::Style::points, color };
      points.push_back(std::move(point));
      if (past.x.size() > 1) // VTK takes one point for no line
      {
        passed.push_back(std::move(past));
      }
    }
  }
  now.lines.insert(now.lines.end(), passed.begin(), passed.end());
  now.lines.insert(now.lines.end(), points.begin(), points.end());
  return now;
}

SideChart::SideChart(
  ChartSpec chart, const std::array<double, 4>& viewport, const std::array<int, 2>& size)
  : chart_(std::move(chart)), viewport_(viewport), size_(size)
{
}

void SideChart::show(double time)
{
  fill_viewport(renderer_, canvas_,
    make_chart(chart_at(chart_, time), letters * chart_scale(size_[1])), viewport_, size_, inset);
}

}
