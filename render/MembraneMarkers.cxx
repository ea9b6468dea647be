#include "render/MembraneMarkers.h"

#include "render/SmoothSurface.h"
#include "solver/Errors.h"
#include "vtkfilters/Filters/MeshConversion.h"
#include "vtkfilters/Filters/SceneNumbers.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vesicle
{

constexpr const char* velocity_name = "Velocity";

/// A vesicle of a frame, seen from its centroid.
struct MarkedMoment
{
  double time = 0;
  Vector3 center;
  double radius = 0, speed = 0; ///< largest distance of a point, and velocity
  vtkSmartPointer<vtkPolyData> surface;
  vtkNew<vtkStaticCellLocator> locator;

  /// The point of the membrane that is nearest, and its velocity.
  struct Place
  {
    Vector3 x, u;
  };
  Place nearest(const Vector3& y);

private:
  vtkNew<vtkGenericCell> cell;
};

MarkedMoment::Place MarkedMoment::nearest(const Vector3& y)
{
  Place place;
  vtkIdType triangle = 0;
  int sub = 0;
  double distance2 = 0, weights[3], local[3];
  locator->FindClosestPoint(y.data(), place.x.data(), cell, triangle, sub, distance2);
  cell->EvaluatePosition(place.x.data(), nullptr, sub, local, distance2, weights);
  vtkDataArray* velocity = surface->GetPointData()->GetArray(velocity_name);
  place.u.setZero();
  for (int k = 0; k < 3; ++k)
  {
    Vector3 u;
    velocity->GetTuple(cell->GetPointId(k), u.data());
    place.u += weights[k] * u;
  }
  return place;
}

namespace
{

/// What a marker moves at most within a step, in radii of its vesicle.
constexpr double longest_step = 0.1;
constexpr int most_steps = 200; // between two frames

/// The points of one vesicle of the mesh with their velocities.
vtkSmartPointer<vtkPolyData> part_of_surface(
  const TriangleMesh& mesh, vtkDataArray* velocity, const std::vector<int>& points)
{
  Points velocities(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    velocity->GetTuple(points[i], velocities.row(static_cast<Eigen::Index>(i)).data());
  }
  auto part = to_polydata(part_with(mesh, points));
  part->GetPointData()->AddArray(to_array(velocity_name, Eigen::MatrixXd(velocities)));
  return part;
}

std::unique_ptr<MarkedMoment> moment_of(vtkPolyData* part, SmoothSurface& smooth, double time)
{
  auto moment = std::make_unique<MarkedMoment>();
  moment->time = time;
  moment->surface = smooth.refine(part, { velocity_name }).surface;
  vtkPolyData* surface = moment->surface;
  vtkDataArray* velocity = surface->GetPointData()->GetArray(velocity_name);
  moment->center = vector_of(surface_centroid(surface));
  const Vector3 drift = vector_of(centroid_velocity(surface, velocity));
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    Vector3 x, u;
    surface->GetPoint(i, x.data());
    velocity->GetTuple(i, u.data());
    x -= moment->center;
    u -= drift;
    points->InsertNextPoint(x.data());
    velocity->SetTuple(i, u.data());
    moment->radius = std::max(moment->radius, x.norm());
    moment->speed = std::max(moment->speed, u.norm());
  }
  surface->SetPoints(points);
  moment->locator->SetDataSet(surface);
  moment->locator->BuildLocator();
  return moment;
}

/// Carries a marker from one moment to the next by Runge and Kutta's steps of fourth order.
Vector3 carried(Vector3 y, MarkedMoment& from, MarkedMoment& to)
{
  const double time = to.time - from.time;
  const double way = std::max(from.speed, to.speed) * time;
  const int steps =
    std::clamp(static_cast<int>(std::ceil(way / (longest_step * from.radius))), 1, most_steps);
  const double step = 1. / steps;
  const auto velocity = [&](const Vector3& x, double share) -> Vector3
  { return time * ((1 - share) * from.nearest(x).u + share * to.nearest(x).u); };
  for (int k = 0; k < steps; ++k)
  {
    const double share = k * step;
    const Vector3 k1 = velocity(y, share);
    const Vector3 k2 = velocity(y + step / 2 * k1, share + step / 2);
    const Vector3 k3 = velocity(y + step / 2 * k2, share + step / 2);
    const Vector3 k4 = velocity(y + step * k3, share + step);
    y += step / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return to.nearest(y).x;
}

}

struct MembraneMarkers::Vesicle
{
  SmoothSurface smooth;
  std::unique_ptr<MarkedMoment> last;
  std::vector<Vector3> markers; ///< from the centroid
};

MembraneMarkers::MembraneMarkers(int count) : count_(count) {}

MembraneMarkers::~MembraneMarkers() = default;

std::vector<Point3> MembraneMarkers::at(vtkPolyData* surface, double time)
{
  const auto parts = vesicle_points(surface);
  if (vesicles_.empty())
  {
    vesicles_ = std::vector<Vesicle>(parts.size());
  }
  if (parts.size() != vesicles_.size())
  {
    throw InputError(
      fmt::format("markers on {} vesicles, and a frame of {}", vesicles_.size(), parts.size()));
  }
  const TriangleMesh mesh = to_mesh(surface);
  vtkDataArray* velocity = finite_vectors(surface, velocity_name, "markers");
  std::vector<Point3> all;
  for (std::size_t v = 0; v < parts.size(); ++v)
  {
    Vesicle& vesicle = vesicles_[v];
    const auto part = part_of_surface(mesh, velocity, parts[v]);
    auto now = moment_of(part, vesicle.smooth, time);
    const bool first = !vesicle.last;
    if (first)
    {
      for (const long long i : spread_points(part, count_))
      {
        vesicle.markers.push_back(Eigen::Map<const Vector3>(part->GetPoint(i)) - now->center);
      }
    }
    for (Vector3& marker : vesicle.markers)
    {
      marker = first ? marker : carried(marker, *vesicle.last, *now);
      const Vector3 x = marker + now->center;
      all.push_back({ x[0], x[1], x[2] });
    }
    vesicle.last = std::move(now);
  }
  return all;
}

}
