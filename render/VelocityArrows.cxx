#include "render/VelocityArrows.h"

#include "render/SurfaceMeasures.h"
#include "solver/Errors.h"

#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkProperty.h"

#include <algorithm>
#include <limits>

namespace vesicle
{
namespace
{

constexpr vtkIdType arrow_count = 160;
constexpr const char* array_name = "Velocity";

/// Arrows shorter than this share of the longest are left out: they'd be dots.
constexpr double shortest = 0.03;

vtkDataArray* velocity_of(vtkPolyData* surface)
{
  vtkDataArray* velocity = finite_point_array(surface, array_name);
  if (velocity->GetNumberOfComponents() != 3)
  {
    throw InputError("point array \"Velocity\" must have three components for arrows");
  }
  return velocity;
}

Point3 reference_velocity(vtkPolyData* surface, vtkDataArray* velocity, bool comoving)
{
  return comoving ? centroid_velocity(surface, velocity) : Point3{ 0, 0, 0 };
}

Point3 relative_velocity(vtkDataArray* velocity, vtkIdType point, const Point3& reference)
{
  Point3 u;
  velocity->GetTuple(point, u.data());
  vtkMath::Subtract(u.data(), reference.data(), u.data());
  return u;
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

void VelocityArrows::choose_points(vtkPolyData* surface)
{
  // Each next point is the one farthest from all before: even on any mesh.
  const vtkIdType count = surface->GetNumberOfPoints();
  std::vector<double> distance2(count, std::numeric_limits<double>::max());
  points_.clear();
  mesh_points_ = count;
  vtkIdType next = 0;
  for (vtkIdType k = 0; k < std::min(arrow_count, count); ++k)
  {
    points_.push_back(next);
    Point3 chosen;
    surface->GetPoint(next, chosen.data());
    for (vtkIdType i = 0; i < count; ++i)
    {
      Point3 p;
      surface->GetPoint(i, p.data());
      distance2[i] =
        std::min(distance2[i], vtkMath::Distance2BetweenPoints(p.data(), chosen.data()));
    }
    next = std::max_element(distance2.begin(), distance2.end()) - distance2.begin();
  }
}

void VelocityArrows::show(vtkPolyData* surface, bool comoving, double speed, double length)
{
  vtkDataArray* velocity = velocity_of(surface);
  const Point3 reference = reference_velocity(surface, velocity, comoving);
  if (mesh_points_ != surface->GetNumberOfPoints())
  {
    choose_points(surface);
  }
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetNumberOfComponents(3);
  for (const auto i : points_)
  {
    const Point3 u = relative_velocity(velocity, i, reference);
    if (speed > 0 && vtkMath::Norm(u.data()) > shortest * speed)
    {
      points->InsertNextPoint(surface->GetPoint(i));
      vectors->InsertNextTuple(u.data());
    }
  }
  feet_->SetPoints(points);
  feet_->GetPointData()->SetVectors(vectors);
  glyphs_->SetScaleFactor(speed > 0 ? length / speed : 0);
  actor_->SetVisibility(points->GetNumberOfPoints() > 0);
}

double VelocityArrows::largest_speed(vtkPolyData* surface, bool comoving)
{
  vtkDataArray* velocity = velocity_of(surface);
  const Point3 reference = reference_velocity(surface, velocity, comoving);
  double largest = 0;
  for (vtkIdType i = 0; i < velocity->GetNumberOfTuples(); ++i)
  {
    const Point3 u = relative_velocity(velocity, i, reference);
    largest = std::max(largest, vtkMath::Norm(u.data()));
  }
  return largest;
}

}
