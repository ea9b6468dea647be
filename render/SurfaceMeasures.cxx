#include "render/SurfaceMeasures.h"

#include "solver/Errors.h"
#include "solver/mesh/MeshIntegrals.h"
#include "solver/mesh/SelfCrossing.h"
#include "solver/mesh/Topology.h"
#include "solver/mesh/VertexNormals.h"
#include "solver/mesh/repair/Components.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vesicle
{
namespace
{

/// A surface with less counts as enclosing nothing; a discocyte as thin as a membrane is far above
/// it.
constexpr double least_reduced_volume = 1e-3;

/// Polygons are cut into fans.
TriangleMesh fan_mesh(vtkPolyData* surface)
{
  TriangleMesh mesh{ Points(surface->GetNumberOfPoints(), 3), {} };
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    surface->GetPoint(i, mesh.points.row(i).data());
  }
  std::vector<std::array<vtkIdType, 3>> triangles;
  auto cells = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(size, ids);
    for (vtkIdType k = 2; k < size; ++k)
    {
      triangles.push_back({ ids[0], ids[k - 1], ids[k] });
    }
  }
  mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const auto& [a, b, c] = triangles[t];
    mesh.triangles.row(static_cast<Eigen::Index>(t)) << static_cast<int>(a), static_cast<int>(b),
      static_cast<int>(c);
  }
  return mesh;
}

/// Calls visit(centre, area vector, triangle) for each triangle.
template<typename Visitor>
void for_each_triangle(const TriangleMesh& mesh, Visitor&& visit)
{
  for (int t = 0; t < mesh.triangles.rows(); ++t)
  {
    const auto [a, b, c] = corners(mesh, t);
    visit(Vector3((a + b + c) / 3), Vector3((b - a).cross(c - a) / 2), t);
  }
}

bool is_closed(const TriangleMesh& mesh)
{
  constexpr double rounding = 1e-6; // points are often stored as floats
  Vector3 total = Vector3::Zero();
  for_each_triangle(mesh, [&](const Vector3&, const Vector3& area, int) { total += area; });
  return total.norm() <= rounding * flat_area(mesh);
}

bool encloses_a_volume(const TriangleMesh& mesh)
{
  return flat_area(mesh) > 0 && is_closed(mesh) &&
    std::abs(flat_reduced_volume(mesh)) > least_reduced_volume;
}

Vector3 area_centroid(const TriangleMesh& mesh)
{
  // Seen from a point of the mesh: far from the origin no digits are lost.
  const Vector3 origin = mesh.points.row(mesh.triangles(0, 0));
  Vector3 moment = Vector3::Zero();
  for_each_triangle(mesh,
    [&](const Vector3& centre, const Vector3& area, int)
    { moment += area.norm() * (centre - origin); });
  return origin + moment / flat_area(mesh);
}

Point3 to_point(const Vector3& x)
{
  return { x[0], x[1], x[2] };
}

std::string names_of_point_arrays(vtkPolyData* surface)
{
  std::string names;
  for (int i = 0; i < surface->GetPointData()->GetNumberOfArrays(); ++i)
  {
    const char* name = surface->GetPointData()->GetArrayName(i);
    names += (names.empty() ? "" : ", ") + std::string(name ? name : "(unnamed)");
  }
  return names.empty() ? "none" : names;
}

}

Point3 surface_centroid(vtkPolyData* surface)
{
  const TriangleMesh mesh = fan_mesh(surface);
  if (mesh.triangles.rows() == 0)
  {
    throw InputError("the surface has no triangles");
  }
  const Vector3 center = encloses_a_volume(mesh) ? volume_centroid(mesh) : area_centroid(mesh);
  if (!center.allFinite())
  {
    throw InputError("the surface has no area, or points that are not finite");
  }
  return to_point(center);
}

double enclosed_volume(vtkPolyData* surface)
{
  const TriangleMesh mesh = fan_mesh(surface);
  return encloses_a_volume(mesh) ? std::abs(flat_volume(mesh)) : 0;
}

bool hides_its_inside(vtkPolyData* surface)
{
  const TriangleMesh mesh = fan_mesh(surface);
  const Topology kind = topology(mesh);
  if (!kind.closed || !kind.manifold || !kind.oriented)
  {
    return false;
  }
  const auto parts = components_of(mesh);
  const bool outward = std::all_of(parts.begin(), parts.end(),
    [&](const Component& part) { return flat_volume(part_of(mesh, part.triangles)) > 0; });
  return outward && !find_self_crossing(mesh);
}

Point3 centroid_velocity(vtkPolyData* surface, vtkDataArray* velocity)
{
  const TriangleMesh mesh = fan_mesh(surface);
  const bool encloses = encloses_a_volume(mesh);
  const Vector3 center = encloses ? volume_centroid(mesh) : Vector3::Zero();
  const double total = encloses ? flat_volume(mesh) : flat_area(mesh);
  Vector3 sum = Vector3::Zero();
  for_each_triangle(mesh,
    [&](const Vector3& centre, const Vector3& area, int t)
    {
      Vector3 u = Vector3::Zero();
      for (const int corner : mesh.triangles.row(t))
      {
        u += Vector3(velocity->GetComponent(corner, 0), velocity->GetComponent(corner, 1),
               velocity->GetComponent(corner, 2)) /
          3;
      }
      sum += encloses ? Vector3((centre - center) * u.dot(area)) : Vector3(u * area.norm());
    });
  return to_point(sum / total);
}

std::vector<Point3> point_normals(vtkPolyData* surface)
{
  std::vector<Point3> normals(static_cast<std::size_t>(surface->GetNumberOfPoints()), Point3{});
  vtkDataArray* own = surface->GetPointData()->GetArray("Normals");
  if (own && own->GetNumberOfComponents() == 3)
  {
    for (std::size_t i = 0; i < normals.size(); ++i)
    {
      own->GetTuple(static_cast<vtkIdType>(i), normals[i].data());
    }
    return normals;
  }
  const TriangleMesh mesh = fan_mesh(surface);
  const Points weighted = vertex_normals(mesh.points, mesh.triangles);
  std::ranges::transform(weighted.rowwise(), normals.begin(), to_point);
  return normals;
}

vtkDataArray* finite_point_array(vtkPolyData* surface, const std::string& name)
{
  vtkDataArray* array = surface->GetPointData()->GetArray(name.c_str());
  const std::string there_are = "; its point arrays: " + names_of_point_arrays(surface);
  if (!array)
  {
    throw InputError(fmt::format("the surface has no point array \"{}\"{}", name, there_are));
  }
  if (array->GetNumberOfComponents() != 1 && array->GetNumberOfComponents() != 3)
  {
    throw InputError(fmt::format("point array \"{}\" has {} components instead of 1 or 3{}", name,
      array->GetNumberOfComponents(), there_are));
  }
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    if (!std::isfinite(scalar_value(array, i)))
    {
      throw InputError(
        fmt::format("point array \"{}\" is not finite at point {}{}", name, i, there_are));
    }
  }
  return array;
}

vtkDataArray* finite_vectors(vtkPolyData* surface, const std::string& name, const std::string& what)
{
  vtkDataArray* array = finite_point_array(surface, name);
  if (array->GetNumberOfComponents() != 3)
  {
    throw InputError(
      fmt::format("point array \"{}\" must have three components for {}", name, what));
  }
  return array;
}

std::vector<long long> spread_points(vtkPolyData* surface, int count)
{
  const vtkIdType all = surface->GetNumberOfPoints();
  std::vector<double> distance2(all, std::numeric_limits<double>::max());
  std::vector<long long> chosen;
  vtkIdType next = 0;
  while (static_cast<vtkIdType>(chosen.size()) < std::min<vtkIdType>(count, all))
  {
    chosen.push_back(next);
    Point3 last;
    surface->GetPoint(next, last.data());
    for (vtkIdType i = 0; i < all; ++i)
    {
      Point3 p;
      surface->GetPoint(i, p.data());
      distance2[i] = std::min(distance2[i], vtkMath::Distance2BetweenPoints(p.data(), last.data()));
    }
    next = std::max_element(distance2.begin(), distance2.end()) - distance2.begin();
  }
  return chosen;
}

double scalar_value(vtkDataArray* array, long long point)
{
  if (array->GetNumberOfComponents() == 1)
  {
    return array->GetComponent(point, 0);
  }
  return std::hypot(
    array->GetComponent(point, 0), array->GetComponent(point, 1), array->GetComponent(point, 2));
}

}
