#include "render/VelocityArrows.h"

#include "render/SurfaceMeasures.h"

#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkProperty.h"

#include <algorithm>

namespace vesicle
{
namespace
{

constexpr int arrow_count = 160;

/// Arrows shorter than this share of the longest are left out: they'd be dots.
constexpr double shortest = 0.03;

/// Arrows start this far outside, in their longest length: none is half inside the surface.
constexpr double lift = 0.06;

/// One vector a point.
std::vector<Point3> lipid_flow(vtkPolyData* surface, const std::vector<Point3>& normals)
{
  vtkDataArray* velocity = finite_vectors(surface, "Velocity", "arrows");
  const Point3 reference = centroid_velocity(surface, velocity);
  std::vector<Point3> flow(normals.size());
  for (std::size_t i = 0; i < flow.size(); ++i)
  {
    Point3& u = flow[i];
    velocity->GetTuple(static_cast<vtkIdType>(i), u.data());
    vtkMath::Subtract(u.data(), reference.data(), u.data());
    const double across = vtkMath::Dot(u.data(), normals[i].data());
    for (int k = 0; k < 3; ++k)
    {
      u[k] -= across * normals[i][k];
    }
  }
  return flow;
}

}

VelocityArrows::VelocityArrows()
{
  arrow_->SetTipLength(0.3);
  arrow_->SetTipRadius(0.095);
  arrow_->SetShaftRadius(0.03);
  arrow_->SetTipResolution(16);
  arrow_->SetShaftResolution(12);
  glyphs_->SetInputData(feet_);
  glyphs_->SetSourceConnection(arrow_->GetOutputPort());
  glyphs_->SetVectorModeToUseVector();
  glyphs_->SetScaleModeToScaleByVector();
  glyphs_->SetColorModeToColorByScalar();
  mapper_->SetInputConnection(glyphs_->GetOutputPort());
  mapper_->ScalarVisibilityOff();
  actor_->SetMapper(mapper_);
  actor_->GetProperty()->SetColor(0.13, 0.13, 0.15);
  actor_->GetProperty()->SetAmbient(0.3);
  actor_->GetProperty()->SetDiffuse(0.7);
}

void VelocityArrows::show(vtkPolyData* surface, double speed, double length)
{
  const auto normals = point_normals(surface);
  const auto flow = lipid_flow(surface, normals);
  if (mesh_points_ != surface->GetNumberOfPoints())
  {
    points_ = spread_points(surface, arrow_count);
    mesh_points_ = surface->GetNumberOfPoints();
  }
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetNumberOfComponents(3);
  for (const auto i : points_)
  {
    const Point3& u = flow[i];
    if (speed > 0 && vtkMath::Norm(u.data()) > shortest * speed)
    {
      Point3 foot;
      surface->GetPoint(i, foot.data());
      for (int k = 0; k < 3; ++k)
      {
        foot[k] += lift * length * normals[i][k];
      }
      points->InsertNextPoint(foot.data());
      vectors->InsertNextTuple(u.data());
    }
  }
  feet_->SetPoints(points);
  feet_->GetPointData()->SetVectors(vectors);
  glyphs_->SetScaleFactor(speed > 0 ? length / speed : 0);
  actor_->SetVisibility(points->GetNumberOfPoints() > 0);
}

double VelocityArrows::largest_speed(vtkPolyData* surface)
{
  double largest = 0;
  for (const Point3& u : lipid_flow(surface, point_normals(surface)))
  {
    largest = std::max(largest, vtkMath::Norm(u.data()));
  }
  return largest;
}

}
