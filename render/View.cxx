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

}

View View::named(const std::string& name)
{
  const Point3 z_up{ 0, 0, 1 };
  if (name == "auto")
  {
    return view_from({ 0, -1, 0 }, z_up);
  }
  if (name == "x")
  {
    return view_from({ 1, 0, 0 }, z_up);
  }
  if (name == "y")
  {
    return view_from({ 0, 1, 0 }, z_up);
  }
  if (name == "z")
  {
    return view_from({ 0, 0, 1 }, { 0, 1, 0 });
  }
  if (name == "isometric")
  {
    return view_from({ 1, -1, 1 }, z_up);
  }
  throw InputError("unknown view \"" + name + "\": use auto, x, y, z or isometric");
}

void Framing::include(vtkPolyData* surface, const View& view)
{
  const Point3 center = surface_centroid(surface);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    Point3 p;
    surface->GetPoint(i, p.data());
    for (int k = 0; k < 3; ++k)
    {
      p[k] -= center[k];
    }
    half_width = std::max(half_width, std::abs(vtkMath::Dot(p.data(), view.right.data())));
    half_height = std::max(half_height, std::abs(vtkMath::Dot(p.data(), view.up.data())));
    radius = std::max(radius, vtkMath::Norm(p.data()));
  }
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
