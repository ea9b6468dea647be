#include "render/MarkerDots.h"

#include "vtkGlyph3D.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

namespace vesicle
{
namespace
{

constexpr double size = 0.022; // in radii of the vesicle

}

MarkerDots::MarkerDots()
{
  dot_->SetThetaResolution(16);
  dot_->SetPhiResolution(16);
  vtkNew<vtkGlyph3D> dots;
  dots->SetInputData(places_);
  dots->SetSourceConnection(dot_->GetOutputPort());
  dots->ScalingOff();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(dots->GetOutputPort());
  actor_->SetMapper(mapper);
  actor_->GetProperty()->SetColor(0.13, 0.13, 0.15);
  actor_->VisibilityOff();
}

void MarkerDots::add_to(vtkRenderer* renderer)
{
  renderer->AddActor(actor_);
}

void MarkerDots::show(const std::vector<Point3>& places, double radius)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Point3& place : places)
  {
    points->InsertNextPoint(place.data());
  }
  places_->SetPoints(points);
  dot_->SetRadius(size * radius);
  actor_->SetVisibility(!places.empty());
}

}
