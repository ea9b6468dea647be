#include "render/View.h"

#include "solver/Errors.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace vesicle
{
namespace
{

View view_from(Point3 toward_camera, const Point3& up)
{
  View v{};
  vtkMath::Normalize(toward_camera.data());
  v.toward_camera = toward_camera;
  vtkMath::Cross(up.data(), toward_camera.data(), v.right.data());
  vtkMath::Normalize(v.right.data());
  vtkMath::Cross(toward_camera.data(), v.right.data(), v.up.data());
  return v;
}

/// Point i from `origin`, along the view's axes.
Point3 seen(vtkPolyData* surface, vtkIdType i, const Point3& origin, const View& view)
{
  Point3 p;
  surface->GetPoint(i, p.data());
  vtkMath::Subtract(p.data(), origin.data(), p.data());
  return { vtkMath::Dot(p.data(), view.right.data()), vtkMath::Dot(p.data(), view.up.data()),
    vtkMath::Dot(p.data(), view.toward_camera.data()) };
}

}

View View::named(const std::string& name)
{
  const Point3 z_up{ 0, 0, 1 };
  const auto is = [&](std::initializer_list<const char*> names)
  { return std::find(names.begin(), names.end(), name) != names.end(); };
  if (is({ "auto", "front", "xz" }))
  {
    return view_from({ 0, -1, 0 }, z_up);
  }
  if (is({ "side", "yz", "x" }))
  {
    return view_from({ 1, 0, 0 }, z_up);
  }
  if (is({ "y" }))
  {
    return view_from({ 0, 1, 0 }, z_up);
  }
  if (is({ "top", "xy", "z" }))
  {
    return view_from({ 0, 0, 1 }, { 0, 1, 0 });
  }
  if (is({ "iso", "isometric" }))
  {
    return view_from({ 1, -1, 1 }, z_up);
  }
  throw InputError("unknown view \"" + name +
    "\": use auto, front, side, top, iso, xz, yz, xy, x, y, z or isometric");
}

void Framing::include(vtkPolyData* surface, const View& view)
{
  const Point3 middle = surface_centroid(surface);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const Point3 p = seen(surface, i, middle, view);
    half_width = std::max(half_width, std::abs(p[0]));
    half_height = std::max(half_height, std::abs(p[1]));
    radius = std::max(radius, vtkMath::Norm(p.data()));
  }
}

void Passage::include(vtkPolyData* surface, const View& view)
{
  Framing alone;
  alone.include(surface, view);
  radius_ = std::max(radius_, alone.radius);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const Point3 p = seen(surface, i, { 0, 0, 0 }, view);
    for (int k = 0; k < 3; ++k)
    {
      low_[k] = any_ ? std::min(low_[k], p[k]) : p[k];
      high_[k] = any_ ? std::max(high_[k], p[k]) : p[k];
    }
    any_ = true;
  }
}

Framing Passage::framing(const View& view) const
{
  Framing all{ 0.5 * (high_[0] - low_[0]), 0.5 * (high_[1] - low_[1]), radius_, Point3{} };
  for (int i = 0; i < 3; ++i)
  {
    (*all.center)[i] = 0.5 *
      ((low_[0] + high_[0]) * view.right[i] + (low_[1] + high_[1]) * view.up[i] +
        (low_[2] + high_[2]) * view.toward_camera[i]);
  }
  return all;
}

void aim_camera(vtkCamera* camera, const View& view, const Point3& focus, const Framing& framing,
  double margin, double usable_width, double aspect)
{
  constexpr double distance = 10; // in radii; only the direction matters in parallel projection
  const double half_height =
    margin * std::max(framing.half_height, framing.half_width / (usable_width * aspect));
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(focus.data());
  Point3 position;
  for (int i = 0; i < 3; ++i)
  {
    position[i] = focus[i] + distance * framing.radius * view.toward_camera[i];
  }
  camera->SetPosition(position.data());
  camera->SetViewUp(view.up.data());
  camera->SetParallelScale(half_height);
  camera->SetWindowCenter(1 - usable_width, 0);
}

}
