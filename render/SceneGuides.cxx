#include "render/SceneGuides.h"

#include "solver/stokes/AmbientFlow.h"

#include "vtkMath.h"

#include <cmath>

namespace vesicle
{
namespace
{

constexpr double shortest_arrow = 0.1; // of the longest
constexpr double line_end = 1;

Vector3 vector_of(const Point3& p)
{
  return { p[0], p[1], p[2] };
}

Point3 point_of(const Vector3& v)
{
  return { v[0], v[1], v[2] };
}

/// Where the flow is sampled, in units of the drawing.
std::vector<Vector3> sample_points(const Scene::Flow& flow, const Vector3& across)
{
  using Kind = Scene::Flow::Kind;
  constexpr double out = 0.6;
  switch (flow.kind)
  {
    case Kind::uniform:
      return { Vector3::Zero() };
    case Kind::planar_extension:
    case Kind::axisymmetric_extension:
      return { { out, 0, 0 }, { -out, 0, 0 }, { 0, 0, out }, { 0, 0, -out } };
    case Kind::shear:
    case Kind::poiseuille:
      break;
  }
  std::vector<Vector3> points;
  for (const double s : { -0.9, -0.6, -0.3, 0., 0.3, 0.6, 0.9 })
  {
    points.push_back(s * across);
  }
  return points;
}

/// The direction in which a profile varies.
Vector3 across_flow(const Scene::Flow& flow, const View& view)
{
  if (flow.kind != Scene::Flow::Kind::poiseuille)
  {
    return Vector3::UnitZ();
  }
  const Vector3 across = vector_of(view.toward_camera).cross(flow.axis);
  return across.norm() > 1e-6 ? Vector3(across.normalized()) : vector_of(view.up);
}

Guide flow_guide(const Scene::Flow& flow, const View& view)
{
  using Kind = Scene::Flow::Kind;
  const bool profile = flow.kind == Kind::shear || flow.kind == Kind::poiseuille;
  const Vector3 across = across_flow(flow, view);
  const auto samples = sample_points(flow, across);
  Points points(static_cast<Eigen::Index>(samples.size()), 3);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const bool pipe = flow.kind == Kind::poiseuille;
    points.row(static_cast<Eigen::Index>(i)) =
      (pipe ? Vector3(flow.center + flow.radius * samples[i]) : samples[i]).transpose();
  }
  const Points velocity = ambient_velocity(flow, points);
  const double largest = velocity.rowwise().norm().maxCoeff();
  Guide guide{ "flow", {}, {} };
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const Vector3 u = velocity.row(static_cast<Eigen::Index>(i)).transpose();
    if (u.norm() <= shortest_arrow * largest || largest == 0)
    {
      continue;
    }
    // A profile starts from its line, other arrows lie about their points.
    const Vector3 arrow = u / largest;
    const Vector3 from = profile ? samples[i] : Vector3(samples[i] - 0.5 * arrow);
    guide.arrows.push_back({ point_of(from), point_of(from + arrow) });
  }
  if (profile)
  {
    guide.lines.push_back({ point_of(-line_end * across), point_of(line_end * across) });
  }
  return guide;
}

Guide gravity_guide(const Scene::Gravity& gravity)
{
  const double down = !gravity.bond_number && gravity.acceleration < 0 ? -1 : 1;
  return { "gravity", { { { 0, 0, 0.85 * down }, { 0, 0, -0.85 * down } } }, {} };
}

}

std::vector<Guide> scene_guides(const Scene& scene, const View& view)
{
  std::vector<Guide> guides;
  if (scene.gravity)
  {
    guides.push_back(gravity_guide(*scene.gravity));
  }
  if (scene.flow)
  {
    guides.push_back(flow_guide(*scene.flow, view));
  }
  return guides;
}

}
