#pragma once
// The colour bar with its title and round numbers, at the right of a viewport.

#include "render/ColorScale.h"

#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkScalarBarActor.h"
#include "vtkTextActor.h"

#include <string>

class vtkRenderer;

namespace vesicle
{

class ColorBar
{
public:
  /// For a viewport of this many pixels.
  ColorBar(int width, int height);

  void add_to(vtkRenderer* renderer);
  void show(const ColorScale& scale, const std::string& title);

  vtkLookupTable* colors() const { return colors_; }
  /// Share of the viewport's width to leave free for it.
  static double share(int width, int height);

private:
  vtkNew<vtkLookupTable> colors_;
  vtkNew<vtkScalarBarActor> bar_;
  vtkNew<vtkTextActor> title_;
};

}
