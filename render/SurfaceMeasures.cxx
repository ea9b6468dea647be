#include "render/SurfaceMeasures.h"

#include "solver/Errors.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <fmt/format.h>

#include <cmath>

namespace vesicle
{
namespace
{

/// Below this share of the volume of a sphere of the same area a surface counts as enclosing
/// nothing; a discocyte as thin as a membrane is far above it.
constexpr double least_relative_volume = 1e-3;

struct Triangle
{
  std::array<vtkIdType, 3> ids;
  Point3 center;
  Point3 area_vector; ///< area times normal
};

/// Calls visit(Triangle) for every triangle; polygons are cut into fans.
template<typename Visitor>
void for_each_triangle(vtkPolyData* surface, Visitor&& visit)
{
  auto cells = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(size, ids);
    for (vtkIdType k = 2; k < size; ++k)
    {
      Triangle t{ { ids[0], ids[k - 1], ids[k] }, {}, {} };
      Point3 a, b, c;
      surface->GetPoint(t.ids[0], a.data());
      surface->GetPoint(t.ids[1], b.data());
      surface->GetPoint(t.ids[2], c.data());
      Point3 ab, ac;
      for (int i = 0; i < 3; ++i)
      {
        t.center[i] = (a[i] + b[i] + c[i]) / 3;
        ab[i] = b[i] - a[i];
        ac[i] = c[i] - a[i];
      }
      vtkMath::Cross(ab.data(), ac.data(), t.area_vector.data());
      vtkMath::MultiplyScalar(t.area_vector.data(), 0.5);
      visit(t);
    }
  }
}

struct Measures
{
  double area = 0;
  double volume = 0; ///< signed
  Point3 area_center{};
  Point3 volume_center{};
  bool encloses = false;
};

bool is_closed(const Point3& total_area_vector, double area)
{
  constexpr double rounding = 1e-6; // points are often stored as floats
  return vtkMath::Norm(total_area_vector.data()) <= rounding * area;
}

Measures measure(vtkPolyData* surface)
{
  Measures m;
  Point3 area_vector{};
  // Distances from any point nearby: volumes of a small vesicle far from the origin cancel.
  Point3 origin;
  surface->GetCenter(origin.data());
  for_each_triangle(surface,
    [&](const Triangle& t)
    {
      const double area = vtkMath::Norm(t.area_vector.data());
      double height_area = 0;
      for (int i = 0; i < 3; ++i)
      {
        height_area += (t.center[i] - origin[i]) * t.area_vector[i];
      }
      for (int i = 0; i < 3; ++i)
      {
        const double x = t.center[i] - origin[i];
        m.area_center[i] += area * x;
        m.volume_center[i] += height_area / 3 * 0.75 * x; // a cone's centroid
        area_vector[i] += t.area_vector[i];
      }
      m.area += area;
      m.volume += height_area / 3;
    });
  const double sphere = std::pow(m.area, 1.5) / (6 * std::sqrt(vtkMath::Pi()));
  m.encloses =
    is_closed(area_vector, m.area) && std::abs(m.volume) > least_relative_volume * sphere;
  for (int i = 0; i < 3; ++i)
  {
    m.area_center[i] = origin[i] + m.area_center[i] / m.area;
    m.volume_center[i] = origin[i] + m.volume_center[i] / m.volume;
  }
  return m;
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
  if (surface->GetNumberOfPolys() == 0)
  {
    throw InputError("the surface has no triangles");
  }
  const Measures m = measure(surface);
  const Point3& center = m.encloses ? m.volume_center : m.area_center;
  if (!std::isfinite(center[0] + center[1] + center[2]))
  {
    throw InputError("the surface has no area, or points that are not finite");
  }
  return center;
}

double enclosed_volume(vtkPolyData* surface)
{
  const Measures m = measure(surface);
  return m.encloses ? std::abs(m.volume) : 0;
}

Point3 centroid_velocity(vtkPolyData* surface, vtkDataArray* velocity)
{
  const Measures m = measure(surface);
  Point3 sum{};
  for_each_triangle(surface,
    [&](const Triangle& t)
    {
      Point3 u{};
      for (const vtkIdType id : t.ids)
      {
        for (int i = 0; i < 3; ++i)
        {
          u[i] += velocity->GetComponent(id, i) / 3;
        }
      }
      const double area = vtkMath::Norm(t.area_vector.data());
      const double flux = vtkMath::Dot(u.data(), t.area_vector.data());
      for (int i = 0; i < 3; ++i)
      {
        sum[i] +=
          m.encloses ? (t.center[i] - m.volume_center[i]) * flux / m.volume : u[i] * area / m.area;
      }
    });
  return sum;
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
  for_each_triangle(surface,
    [&](const Triangle& t)
    {
      for (const vtkIdType id : t.ids)
      {
        Point3& n = normals[static_cast<std::size_t>(id)];
        vtkMath::Add(n.data(), t.area_vector.data(), n.data());
      }
    });
  for (Point3& n : normals)
  {
    vtkMath::Normalize(n.data());
  }
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
