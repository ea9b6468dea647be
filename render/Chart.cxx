#include "render/Chart.h"

#include "render/ChartItem.h"
#include "render/Picture.h"
#include "render/PngFile.h"
#include "render/RenderBackend.h"
#include "render/SvgFile.h"
#include "solver/Errors.h"

#include "vtkAxis.h"
#include "vtkBrush.h"
#include "vtkChartLegend.h"
#include "vtkChartXY.h"
#include "vtkContextActor.h"
#include "vtkContextScene.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPen.h"
#include "vtkPlotLine.h"
#include "vtkPlotPoints.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <fmt/format.h>

namespace vesicle
{
namespace
{

/// Font sizes in pixels of a chart this high; smaller charts have smaller letters.
constexpr double design_height = 720;
constexpr double least_scale = 0.62;
constexpr int title_font = 28;
constexpr int label_font = 24;
constexpr int tick_font = 20;
constexpr double border_width = 14;
constexpr double dark = 0.15;
constexpr double cross_size = 24;

bool drawable(const ChartSpec& chart, double x, double y)
{
  return std::isfinite(x) && std::isfinite(y) && (!chart.log_x || x > 0) && (!chart.log_y || y > 0);
}

/// The points that can be drawn. Its columns have names of their own, since a table holds one
/// column of a name and a label may be anything.
vtkSmartPointer<vtkTable> table_of(const ChartSpec& chart, const ChartLine& line)
{
  if (line.x.size() != line.y.size())
  {
    throw InputError(fmt::format("chart \"{}\": line \"{}\" has {} abscissas and {} ordinates",
      chart.title, line.label, line.x.size(), line.y.size()));
  }
  vtkNew<vtkDoubleArray> x;
  vtkNew<vtkDoubleArray> y;
  x->SetName("abscissa");
  y->SetName("ordinate");
  for (std::size_t i = 0; i < line.x.size(); ++i)
  {
    if (drawable(chart, line.x[i], line.y[i]))
    {
      x->InsertNextValue(line.x[i]);
      y->InsertNextValue(line.y[i]);
    }
  }
  auto table = vtkSmartPointer<vtkTable>::New();
  table->AddColumn(x);
  table->AddColumn(y);
  return table;
}

void add_line(vtkChartXY* chart, vtkTable* table, const ChartLine& line,
  const std::array<int, 3>& color, double scale)
{
  const bool cross = line.style == ChartLine::Style::cross, alone = table->GetNumberOfRows() == 1,
             points =
               cross || alone || line.style == ChartLine::Style::points; // no line through one
  vtkPlot* plot = chart->AddPlot(points ? vtkChart::POINTS : vtkChart::LINE);
  plot->SetInputData(table, 0, 1);
  plot->SetLabel(line.label);
  plot->SetColor(color[0], color[1], color[2], 255);
  plot->SetWidth(static_cast<float>((points ? 6 : 3) * scale));
  if (auto* markers = vtkPlotPoints::SafeDownCast(plot))
  {
    markers->SetMarkerStyle(cross ? vtkPlotPoints::CROSS
        : points                  ? vtkPlotPoints::CIRCLE
                                  : vtkPlotPoints::NONE);
    if (cross)
      markers->SetMarkerSize(static_cast<float>(cross_size * scale));
  }
  if (line.style == ChartLine::Style::dashed)
  {
    plot->GetPen()->SetLineType(vtkPen::DASH_LINE);
  }
  if (line.label.empty())
  {
    plot->SetLegendVisibility(false);
  }
}

void set_font(vtkTextProperty* text, double size)
{
  text->SetFontFamilyToArial();
  text->SetFontSize(std::max(8, static_cast<int>(std::lround(size))));
  text->SetColor(dark, dark, dark);
  text->BoldOff();
  text->ItalicOff();
}

void set_axis(vtkAxis* axis, const std::string& label, bool logarithmic, double scale)
{
  axis->SetTitle(label);
  set_font(axis->GetTitleProperties(), label_font * scale);
  set_font(axis->GetLabelProperties(), tick_font * scale);
  if (logarithmic)
  {
    axis->SetRange(1, 10); // VTK ignores the wish while the range touches zero
  }
  axis->SetLogScale(logarithmic);
  axis->GetGridPen()->SetColorF(0.88, 0.88, 0.88);
  axis->GetPen()->SetColorF(dark, dark, dark);
  axis->GetPen()->SetWidth(static_cast<float>(1.5 * scale));
}

/// White; VTK leaves black what no renderer takes.
void take_viewport(vtkRenderer* renderer, const std::array<double, 4>& part)
{
  renderer->SetBackground(1, 1, 1);
  renderer->SetViewport(part[0], part[1], part[2], part[3]);
}

/// Widens what one axis of a drawn chart shows, so that a unit is as long on both.
void make_units_equal(vtkChartXY* chart)
{
  vtkAxis *across = chart->GetAxis(vtkAxis::BOTTOM), *up = chart->GetAxis(vtkAxis::LEFT);
  const auto range = [](vtkAxis* axis) { return axis->GetMaximum() - axis->GetMinimum(); };
  const double width = across->GetPoint2()[0] - across->GetPoint1()[0],
               height = up->GetPoint2()[1] - up->GetPoint1()[1];
  const double unit = std::max(range(across) / width, range(up) / height); // a pixel's
  for (const auto& [axis, pixels] : { std::pair{ across, width }, { up, height } })
  {
    const double middle = (axis->GetMinimum() + axis->GetMaximum()) / 2, half = unit * pixels / 2;
    axis->SetBehavior(vtkAxis::FIXED);
    axis->SetRange(middle - half, middle + half);
  }
}

}

std::array<int, 3> chart_color(std::size_t i)
{
  // Okabe and Ito's colours, told apart by colour-blind readers too.
  constexpr std::array<std::array<int, 3>, 7> palette{ { { 0, 114, 178 }, { 213, 94, 0 },
    { 0, 158, 115 }, { 204, 121, 167 }, { 86, 180, 233 }, { 230, 159, 0 }, { 60, 60, 60 } } };
  return palette[i % palette.size()];
}

vtkSmartPointer<vtkChartXY> make_chart(const ChartSpec& spec, double scale)
{
  auto chart = vtkSmartPointer<vtkChartXY>::New();
  chart->SetTitle(spec.title);
  set_font(chart->GetTitleProperties(), title_font * scale);
  chart->GetTitleProperties()->BoldOn();
  set_axis(chart->GetAxis(vtkAxis::BOTTOM), spec.x_label, spec.log_x, scale);
  set_axis(chart->GetAxis(vtkAxis::LEFT), spec.y_label, spec.log_y, scale);
  bool legend = false;
  vtkIdType values = 0;
  for (std::size_t i = 0; i < spec.lines.size(); ++i)
  {
    const auto table = table_of(spec, spec.lines[i]);
    if (table->GetNumberOfRows() > 0)
    {
      add_line(chart, table, spec.lines[i], spec.lines[i].color.value_or(chart_color(i)), scale);
      legend = legend || !spec.lines[i].label.empty();
    }
    values += table->GetNumberOfRows();
  }
  if (values == 0)
  {
    throw InputError(fmt::format("chart \"{}\" has nothing to draw", spec.title));
  }
  chart->SetShowLegend(legend);
  // Outside the axes, where it hides nothing.
  chart->GetLegend()->SetInline(false);
  chart->GetLegend()->SetHorizontalAlignment(vtkChartLegend::RIGHT);
  chart->GetLegend()->GetPen()->SetLineType(vtkPen::NO_PEN);
  set_font(chart->GetLegend()->GetLabelProperties(), tick_font * scale);
  return chart;
}

double chart_scale(int height)
{
  return std::max(least_scale, height / design_height);
}

void fill_viewport(vtkRenderer* renderer, vtkContextActor* canvas, vtkChartXY* chart,
  const std::array<double, 4>& viewport, const std::array<int, 2>& size, double inset)
{
  const double width = (viewport[2] - viewport[0]) * size[0];
  const double height = (viewport[3] - viewport[1]) * size[1];
  const double border = border_width * chart_scale(static_cast<int>(height));
  const double below = std::max(border, inset * height);
  take_viewport(renderer, viewport);
  chart->SetAutoSize(false);
  // Whole pixels: VTK smears letters that lie between them.
  const auto pixels = [](double x) { return static_cast<float>(std::round(x)); };
  chart->SetSize(vtkRectf(
    pixels(border), pixels(below), pixels(width - 2 * border), pixels(height - 2 * below)));
  canvas->GetScene()->ClearItems();
  canvas->GetScene()->AddItem(chart);
  canvas->GetScene()->SetRenderer(renderer);
  renderer->AddActor(canvas);
}

void write_chart(const std::filesystem::path& file, const ChartSpec& chart, std::array<int, 2> size)
{
  write_charts(file, { chart }, 1, size);
}

void write_charts(const std::filesystem::path& file, const std::vector<ChartSpec>& charts,
  int columns, std::array<int, 2> size)
{
  if (charts.empty() || columns < 1)
  {
    throw InputError("there is no chart to write to " + file.string());
  }
  render_backend();
  const int rows = (static_cast<int>(charts.size()) + columns - 1) / columns;
  const double scale = chart_scale(size[1] / rows);
  constexpr int samples = 8; // smooth lines; a chart is drawn once
  const auto window = off_screen_window(size, samples);
  std::vector<vtkSmartPointer<vtkChartXY>> items;
  for (int i = 0; i < rows * columns; ++i)
  {
    const int column = i % columns;
    const int row = rows - 1 - i / columns; // VTK counts from below
    const std::array<double, 4> part{ static_cast<double>(column) / columns,
      static_cast<double>(row) / rows, (column + 1.) / columns, (row + 1.) / rows };
    vtkNew<vtkRenderer> renderer;
    if (i < static_cast<int>(charts.size()))
    {
      vtkNew<vtkContextActor> canvas;
      items.push_back(make_chart(charts[static_cast<std::size_t>(i)], scale));
      fill_viewport(renderer, canvas, items.back(), part, size);
    }
    else
      take_viewport(renderer, part);
    window->AddRenderer(renderer);
  }
  window->Render();
  bool adapted = false;
  for (std::size_t i = 0; i < charts.size(); ++i)
  {
    if (charts[i].equal_axes)
    {
      make_units_equal(items[i]);
      adapted = true;
    }
  }
  if (adapted)
  {
    window->Render();
  }
  if (file.extension() == ".svg")
    write_svg(file, window);
  else
    write_png(file, grab_image(window));
}

}
