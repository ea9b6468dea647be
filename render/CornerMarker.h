#pragma once
// Small drawings along the lower edge of a picture: the axes, and what drives the vesicle.

#include "render/ColorMap.h"
#include "render/View.h"

#include "vtkNew.h"
#include "vtkRenderer.h"

#include <memory>
#include <string>
#include <vector>

namespace vesicle
{

/// A flow or gravity, drawn as arrows within the unit sphere.
struct Guide
{
  struct Arrow
  {
    Point3 from;
    Point3 to;
  };
  std::string label;
  std::vector<Arrow> arrows;
  std::vector<Arrow> lines; ///< without a head: where the arrows start
};

/// Which square of the picture, counted from the lower left corner.
struct Slot
{
  int column = 0;
  int row = 0;
};

/// A square, a fifth of the picture's height wide, seen from the direction of the picture.
class CornerMarker
{
public:
  CornerMarker(const View& view, int picture_width, int picture_height, Slot slot);

  vtkRenderer* renderer() const { return renderer_; }

  void add_arrow(const Guide::Arrow& arrow, const Color& color);
  void add_line(const Guide::Arrow& line, const Color& color);
  void add_text(const Point3& position, const std::string& text);

private:
  int font_size_;
  vtkNew<vtkRenderer> renderer_;
};

/// Arrows for x, y and z but for one that points at the viewer.
std::unique_ptr<CornerMarker> axes_marker(
  const View& view, int picture_width, int picture_height, Slot slot);

/// Empty where the view looks along all of the guide's arrows.
std::unique_ptr<CornerMarker> guide_marker(
  const Guide& guide, const View& view, int picture_width, int picture_height, Slot slot);

}
