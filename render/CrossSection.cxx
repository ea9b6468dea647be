#include "render/CrossSection.h"

#include "render/ColorMap.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCutter.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPolyData.h"
#include "vtkStripper.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vesicle
{
namespace
{

/// Times in a legend; of more, some have none.
constexpr std::size_t most_labels = 12;

/// "x" of a direction along the x axis, "−x" of the other way.
std::string axis_name(const Point3& direction)
{
  constexpr double nearly = 1 - 1e-9;
  for (std::size_t k = 0; k < 3; ++k)
    if (std::abs(direction[k]) > nearly)
      return fmt::format("{}{}", direction[k] < 0 ? "-" : "", "xyz"[k]);
  return "";
}

std::array<int, 3> bytes_of(const Color& color)
{
  std::array<int, 3> bytes{};
  std::transform(color.begin(), color.end(), bytes.begin(),
    [](double c) { return static_cast<int>(std::lround(255 * c)); });
  return bytes;
}

/// From dark to light; the lightest can't be seen on white.
std::vector<Color> colors_of_times(std::size_t count)
{
  auto colors =
    color_table(ColorMap::sequential, static_cast<int>(std::max<std::size_t>(count, 2)) + 1);
  colors.pop_back();
  return colors;
}

}

std::vector<ChartLine> cut(vtkPolyData* surface, const View& view, const Point3& origin)
{
  const Point3 middle = surface_centroid(surface);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(middle.data());
  plane->SetNormal(view.toward_camera.data());
  vtkNew<vtkCutter> cutter;
  cutter->SetInputData(surface);
  cutter->SetCutFunction(plane);
  vtkNew<vtkStripper> strips;
  strips->SetInputConnection(cutter->GetOutputPort());
  strips->JoinContiguousSegmentsOn();
  strips->Update();
  vtkPolyData* lines = strips->GetOutput();
  std::vector<ChartLine> outlines;
  auto line = vtk::TakeSmartPointer(lines->GetLines()->NewIterator());
  for (line->GoToFirstCell(); !line->IsDoneWithTraversal(); line->GoToNextCell())
  {
    ChartLine outline;
    vtkIdType size;
    const vtkIdType* ids;
    line->GetCurrentCell(size, ids);
    for (vtkIdType i = 0; i < size; ++i)
    {
      Point3 p;
      lines->GetPoint(ids[i], p.data());
      vtkMath::Subtract(p.data(), origin.data(), p.data());
      outline.x.push_back(vtkMath::Dot(p.data(), view.right.data()));
      outline.y.push_back(vtkMath::Dot(p.data(), view.up.data()));
    }
    outlines.push_back(std::move(outline));
  }
  return outlines;
}

ChartSpec section_chart(
  const std::vector<CrossSection>& sections, const View& view, bool about_centroids)
{
  ChartSpec chart;
  chart.title = "Cross-section";
  chart.x_label = axis_name(view.right);
  chart.y_label = axis_name(view.up);
  chart.equal_axes = true;
  const auto colors = colors_of_times(sections.size());
  const std::size_t every = (sections.size() + most_labels - 1) / most_labels;
  for (std::size_t i = 0; i < sections.size(); ++i)
  {
    const Point3 origin =
      about_centroids ? surface_centroid(sections[i].surface) : Point3{ 0, 0, 0 };
    auto outlines = cut(sections[i].surface, view, origin);
    if (!outlines.empty() && sections.size() > 1 && i % every == 0)
      outlines.front().label = fmt::format("t = {:.4g}", sections[i].time);
    for (ChartLine& outline : outlines)
    {
      outline.color = bytes_of(colors[i]);
      chart.lines.push_back(std::move(outline));
    }
  }
  return chart;
}

}
