#include "render/CornerMarker.h"

#include "render/TextStyle.h"

#include "vtkActor.h"
#include "vtkArrowSource.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkCamera.h"
#include "vtkLineSource.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>

namespace vesicle
{
namespace
{

constexpr double side = 0.2;      // of the picture's height
constexpr double label_at = 1.22; // in lengths of an axis
constexpr double half_view = 1.6; // likewise
constexpr double caption_at = -1.3;
constexpr double foreshortened = 0.25; // a shorter arrow says nothing
constexpr Color guide_color{ 0.22, 0.22, 0.25 };

Point3 difference(const Point3& a, const Point3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

/// Takes the arrow from 0 to e_x, which VTK makes, to this one.
vtkSmartPointer<vtkMatrix4x4> placement(const Guide::Arrow& arrow)
{
  Point3 x = difference(arrow.to, arrow.from), y, z;
  const double length = vtkMath::Normalize(x.data());
  vtkMath::Perpendiculars(x.data(), y.data(), z.data(), 0);
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  for (int i = 0; i < 3; ++i)
  {
    matrix->SetElement(i, 0, length * x[i]);
    matrix->SetElement(i, 1, length * y[i]);
    matrix->SetElement(i, 2, length * z[i]);
    matrix->SetElement(i, 3, arrow.from[i]);
  }
  return matrix;
}

bool visible(const Guide::Arrow& arrow, const View& view)
{
  const Point3 d = difference(arrow.to, arrow.from);
  const double across =
    std::hypot(vtkMath::Dot(d.data(), view.right.data()), vtkMath::Dot(d.data(), view.up.data()));
  return across > foreshortened * vtkMath::Norm(d.data());
}

}

CornerMarker::CornerMarker(const View& view, int picture_width, int picture_height, Slot slot)
  : font_size_(std::max(8, static_cast<int>(font_size(font::small, picture_height))))
{
  const double width = side * picture_height / picture_width;
  const auto shown = [](double share) { return std::min(1., share); };
  renderer_->SetViewport(shown(slot.column * width), shown(slot.row * side),
    shown((slot.column + 1) * width), shown((slot.row + 1) * side));
  renderer_->SetLayer(1);
  renderer_->InteractiveOff();
  const Framing framing{ half_view, half_view, half_view, {} };
  aim_camera(renderer_->GetActiveCamera(), view, { 0, 0, 0 }, framing, 1, 1, 1);
}

void CornerMarker::add_arrow(const Guide::Arrow& arrow, const Color& color)
{
  vtkNew<vtkArrowSource> source;
  source->SetTipLength(0.3);
  source->SetTipRadius(0.12);
  source->SetShaftRadius(0.035);
  source->SetTipResolution(24);
  source->SetShaftResolution(16);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetAmbient(0.4);
  actor->GetProperty()->SetDiffuse(0.6);
  actor->SetUserMatrix(placement(arrow));
  renderer_->AddActor(actor);
}

void CornerMarker::add_line(const Guide::Arrow& line, const Color& color)
{
  vtkNew<vtkLineSource> source;
  source->SetPoint1(line.from[0], line.from[1], line.from[2]);
  source->SetPoint2(line.to[0], line.to[1], line.to[2]);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetLineWidth(static_cast<float>(std::max(1., font_size_ / 14.)));
  actor->GetProperty()->LightingOff();
  renderer_->AddActor(actor);
}

void CornerMarker::add_text(const Point3& position, const std::string& text)
{
  vtkNew<vtkBillboardTextActor3D> label;
  label->SetInput(text.c_str());
  label->SetPosition(position[0], position[1], position[2]);
  set_text_style(label->GetTextProperty(), font_size_);
  label->GetTextProperty()->SetJustificationToCentered();
  label->GetTextProperty()->SetVerticalJustificationToCentered();
  renderer_->AddActor(label);
}

std::unique_ptr<CornerMarker> axes_marker(
  const View& view, int picture_width, int picture_height, Slot slot)
{
  constexpr Color colors[] = { { .75, .2, .2 }, { .2, .55, .25 }, { .2, .3, .75 } };
  constexpr const char* names[] = { "x", "y", "z" };
  auto marker = std::make_unique<CornerMarker>(view, picture_width, picture_height, slot);
  for (int axis = 0; axis < 3; ++axis)
  {
    Guide::Arrow arrow{};
    arrow.to[axis] = 1;
    if (visible(arrow, view))
    {
      marker->add_arrow(arrow, colors[axis]);
      Point3 end{};
      end[axis] = label_at;
      marker->add_text(end, names[axis]);
    }
  }
  return marker;
}

std::unique_ptr<CornerMarker> guide_marker(
  const Guide& guide, const View& view, int picture_width, int picture_height, Slot slot)
{
  auto marker = std::make_unique<CornerMarker>(view, picture_width, picture_height, slot);
  bool any = false;
  for (const auto& arrow : guide.arrows)
  {
    if (visible(arrow, view))
    {
      marker->add_arrow(arrow, guide_color);
      any = true;
    }
  }
  if (!any)
  {
    return nullptr;
  }
  for (const auto& line : guide.lines)
  {
    marker->add_line(line, guide_color);
  }
  Point3 below;
  for (int i = 0; i < 3; ++i)
  {
    below[i] = caption_at * view.up[i];
  }
  marker->add_text(below, guide.label);
  return marker;
}

}
