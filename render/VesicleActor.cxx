#include "render/VesicleActor.h"

#include "render/SurfaceMeasures.h"

#include "vtkDataArray.h"
#include "vtkLookupTable.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

namespace vesicle
{
namespace
{

constexpr double edge_gray = 0.2;

}

VesicleActor::VesicleActor(Look look, vtkLookupTable* colors) : look_(std::move(look))
{
  normals_->SplittingOff();
  mapper_->SetLookupTable(colors);
  mapper_->SetScalarModeToUsePointFieldData();
  mapper_->UseLookupTableScalarRangeOn();
  mapper_->InterpolateScalarsBeforeMappingOn();
  actor_->SetMapper(mapper_);
  vtkProperty* surface = actor_->GetProperty();
  surface->SetInterpolationToPhong();
  surface->SetAmbient(0.45);
  surface->SetDiffuse(0.62);
  surface->SetSpecular(0.07);
  surface->SetSpecularPower(25);
  surface->SetEdgeVisibility(look_.edges && !look_.smooth);
  surface->SetEdgeColor(edge_gray, edge_gray, edge_gray);
  surface->SetLineWidth(static_cast<float>(look_.line_width));
  edges_->SetMapper(edge_mapper_);
  edges_->GetProperty()->SetColor(edge_gray, edge_gray, edge_gray);
  edges_->GetProperty()->SetLineWidth(static_cast<float>(look_.line_width));
  edges_->GetProperty()->LightingOff();
  edges_->SetVisibility(look_.edges && look_.smooth);
  edge_mapper_->SetResolveCoincidentTopologyToPolygonOffset(); // in front of the surface
  edge_mapper_->SetRelativeCoincidentTopologyLineOffsetParameters(-4, -60);
  arrows_.actor()->SetVisibility(look_.arrows);
}

void VesicleActor::add_to(vtkRenderer* renderer)
{
  renderer->AddActor(actor_);
  renderer->AddActor(edges_);
  renderer->AddActor(arrows_.actor());
}

void VesicleActor::set_surface(vtkPolyData* surface)
{
  vtkDataArray* own = surface->GetPointData()->GetArray("Normals");
  if (own && own->GetNumberOfComponents() == 3)
  {
    vtkNew<vtkPolyData> with_normals;
    with_normals->ShallowCopy(surface);
    with_normals->GetPointData()->SetNormals(own);
    mapper_->SetInputData(with_normals);
    return;
  }
  normals_->SetInputData(surface);
  mapper_->SetInputConnection(normals_->GetOutputPort());
}

void VesicleActor::show(vtkPolyData* surface)
{
  vtkDataArray* array = finite_point_array(surface, look_.color);
  if (array->GetNumberOfComponents() > 1)
  {
    mapper_->GetLookupTable()->SetVectorModeToMagnitude();
  }
  mapper_->SelectColorArray(look_.color.c_str());
  // What its front hides needn't be drawn, half of what there is.
  actor_->GetProperty()->SetBackfaceCulling(hides_its_inside(surface));
  if (look_.smooth)
  {
    const SmoothMesh fine = smooth_.refine(surface, { look_.color });
    edge_mapper_->SetInputData(fine.edges);
    set_surface(fine.surface);
  }
  else
  {
    set_surface(surface);
  }
}

void VesicleActor::show_arrows(vtkPolyData* surface, double speed, double length)
{
  if (look_.arrows)
  {
    arrows_.show(surface, speed, length);
  }
}

void VesicleActor::place(const Point3& shift)
{
  for (vtkActor* actor : { actor_.Get(), edges_.Get(), arrows_.actor() })
  {
    actor->SetPosition(shift[0], shift[1], shift[2]);
  }
}

}
