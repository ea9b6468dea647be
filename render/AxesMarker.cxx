#include "render/AxesMarker.h"

#include "vtkActor.h"
#include "vtkArrowSource.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkCamera.h"
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

constexpr double side = 0.2;       // of the picture's height
constexpr double label_at = 1.22;  // in lengths of an axis
constexpr double half_view = 1.45; // likewise
constexpr double along_view = 0.97;

/// Turns +x, where vtkArrowSource points, to the axis.
void orient(vtkActor* actor, int axis)
{
  vtkNew<vtkMatrix4x4> turn;
  turn->Zero();
  for (int column = 0; column < 3; ++column)
  {
    turn->SetElement((axis + column) % 3, column, 1);
  }
  turn->SetElement(3, 3, 1);
  actor->SetUserMatrix(turn);
}

}

AxesMarker::AxesMarker(const View& view, int picture_width, int picture_height)
{
  const double width = side * picture_height / picture_width;
  renderer_->SetViewport(0, 0, std::min(1., width), side);
  renderer_->SetLayer(1);
  renderer_->InteractiveOff();
  for (int axis = 0; axis < 3; ++axis)
  {
    if (std::abs(view.toward_camera[axis]) < along_view)
    {
      add_axis(axis, std::max(8, picture_height / 32));
    }
  }
  Framing framing{ half_view, half_view, half_view };
  aim_camera(renderer_->GetActiveCamera(), view, { 0, 0, 0 }, framing, 1, 1, 1);
}

void AxesMarker::add_axis(int axis, int font_size)
{
  constexpr double colors[3][3] = { { .75, .2, .2 }, { .2, .55, .25 }, { .2, .3, .75 } };
  vtkNew<vtkArrowSource> arrow;
  arrow->SetTipLength(0.3);
  arrow->SetTipRadius(0.12);
  arrow->SetShaftRadius(0.035);
  arrow->SetTipResolution(24);
  arrow->SetShaftResolution(16);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(arrow->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(colors[axis][0], colors[axis][1], colors[axis][2]);
  actor->GetProperty()->SetAmbient(0.4);
  actor->GetProperty()->SetDiffuse(0.6);
  orient(actor, axis);
  renderer_->AddActor(actor);

  constexpr const char* names[] = { "x", "y", "z" };
  Point3 position{};
  position[axis] = label_at;
  vtkNew<vtkBillboardTextActor3D> label;
  label->SetInput(names[axis]);
  label->SetPosition(position.data());
  label->GetTextProperty()->SetFontSize(font_size);
  label->GetTextProperty()->SetColor(0.15, 0.15, 0.15);
  label->GetTextProperty()->SetJustificationToCentered();
  label->GetTextProperty()->SetVerticalJustificationToCentered();
  renderer_->AddActor(label);
}

}
