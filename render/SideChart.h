#pragma once
// A chart beside the vesicle that shows how far time has come.

#include "render/Chart.h"

#include "vtkContextActor.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

namespace vesicle
{

/// The whole course in pale lines, what has passed in full colour, now as points. The abscissa is
/// the time.
class SideChart
{
public:
  SideChart(ChartSpec chart, const std::array<double, 4>& viewport, const std::array<int, 2>& size);

  void show(double time);

  vtkRenderer* renderer() const { return renderer_; }

private:
  ChartSpec chart_;
  std::array<double, 4> viewport_;
  std::array<int, 2> size_;
  vtkNew<vtkContextActor> canvas_;
  vtkNew<vtkRenderer> renderer_;
};

/// The chart as it is at this time.
ChartSpec chart_at(const ChartSpec& chart, double time);

}
