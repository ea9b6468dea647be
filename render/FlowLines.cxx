#include "render/FlowLines.h"

#include "vtkCellArray.h"
#include "vtkConeSource.h"
#include "vtkDoubleArray.h"
#include "vtkGlyph3D.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace vesicle
{
namespace
{

constexpr double gray = 0.55;       // texts are read above it
constexpr double line_width = 1.5;  // pixels
constexpr double tip_length = 0.22; // in distances between the lines' starts
constexpr double tip_share = 0.5;   // of a short line's length

vtkSmartPointer<vtkMatrix4x4> place_of(const FlowPlane& plane)
{
  auto place = vtkSmartPointer<vtkMatrix4x4>::New();
  for (int k = 0; k < 3; ++k)
  {
    place->SetElement(k, 0, plane.view.right[k]);
    place->SetElement(k, 1, plane.view.up[k]);
    place->SetElement(k, 2, plane.view.toward_camera[k]);
    place->SetElement(k, 3, plane.center[k]);
  }
  return place;
}

}

FlowLines::FlowLines()
{
  vtkNew<vtkPolyDataMapper> lines;
  lines->SetInputData(lines_);
  line_actor_->SetMapper(lines);
  vtkNew<vtkConeSource> cone;
  cone->SetHeight(1);
  cone->SetRadius(0.35);
  cone->SetResolution(16);
  vtkNew<vtkGlyph3D> tips;
  tips->SetInputData(tips_);
  tips->SetSourceConnection(cone->GetOutputPort());
  tips->SetVectorModeToUseVector();
  tips->SetScaleModeToScaleByVector();
  vtkNew<vtkPolyDataMapper> cones;
  cones->SetInputConnection(tips->GetOutputPort());
  tip_actor_->SetMapper(cones);
  for (vtkActor* actor : { line_actor_.Get(), tip_actor_.Get() })
  {
    actor->GetProperty()->SetColor(gray, gray, gray);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetLineWidth(line_width);
    actor->VisibilityOff();
  }
}

void FlowLines::add_to(vtkRenderer* renderer)
{
  renderer->AddActor(line_actor_);
  renderer->AddActor(tip_actor_);
}

void FlowLines::show(const FlowWays& flow, const FlowPlane& plane)
{
  vtkNew<vtkPoints> points, ends;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkDoubleArray> directions;
  directions->SetNumberOfComponents(3);
  for (const Way& way : flow.ways)
  {
    lines->InsertNextCell(static_cast<int>(way.size()));
    for (const Point3& x : way)
    {
      lines->InsertCellPoint(points->InsertNextPoint(x.data()));
    }
    Point3 along;
    vtkMath::Subtract(way.back().data(), way[way.size() - 2].data(), along.data());
    vtkMath::Normalize(along.data());
    vtkMath::MultiplyScalar(
      along.data(), std::min(tip_length * flow.distance, tip_share * length_of(way)));
    ends->InsertNextPoint(way.back().data());
    directions->InsertNextTuple(along.data());
  }
  lines_->SetPoints(points);
  lines_->SetLines(lines);
  tips_->SetPoints(ends);
  tips_->GetPointData()->SetVectors(directions);
  const auto place = place_of(plane);
  for (vtkActor* actor : { line_actor_.Get(), tip_actor_.Get() })
  {
    actor->SetUserMatrix(place);
    actor->SetVisibility(!flow.ways.empty());
  }
}

}
