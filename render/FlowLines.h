#pragma once
// The flow of the fluid as lines with an arrow at their end.

#include "render/FlowWays.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

class vtkRenderer;

namespace vesicle
{

class FlowLines
{
public:
  FlowLines();

  void add_to(vtkRenderer* renderer);

  void show(const FlowWays& flow, const FlowPlane& plane);

private:
  vtkNew<vtkPolyData> lines_, tips_; ///< in the plane's own directions
  vtkNew<vtkActor> line_actor_, tip_actor_;
};

}
