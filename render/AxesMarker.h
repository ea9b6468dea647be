#pragma once
// A small cross of the coordinate axes in the picture's lower left corner.

#include "render/View.h"

#include "vtkNew.h"
#include "vtkRenderer.h"

namespace vesicle
{

class AxesMarker
{
public:
  /// An axis that points at the viewer is left out: its label would hide the others'.
  AxesMarker(const View& view, int picture_width, int picture_height);

  /// To be added to the window as layer 1.
  vtkRenderer* renderer() const { return renderer_; }

private:
  void add_axis(int axis, int font_size);

  vtkNew<vtkRenderer> renderer_;
};

}
