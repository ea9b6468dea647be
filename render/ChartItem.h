#pragma once
// A chart as an item of a VTK scene, for files and for pictures that have one at their side.

#include "render/Chart.h"

#include "vtkSmartPointer.h"

class vtkChartXY;
class vtkContextActor;
class vtkRenderer;

namespace vesicle
{

/// Colour of the i-th line.
std::array<int, 3> chart_color(std::size_t i);

/// Size of letters and lines for a chart of this many pixels, 1 at a height of 720.
double chart_scale(int height);

/// Throws InputError when x and y differ in length or nothing is left to draw.
vtkSmartPointer<vtkChartXY> make_chart(const ChartSpec& chart, double scale);

/// Shows the chart, and nothing else, in this part (x0, y0, x1, y1; shares) of a window of `size`
/// pixels; `inset` (a share of the part's height) stays free above and below.
void fill_viewport(vtkRenderer* renderer, vtkContextActor* canvas, vtkChartXY* chart,
  const std::array<double, 4>& viewport, const std::array<int, 2>& size, double inset = 0);

}
