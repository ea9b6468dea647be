#include "render/SceneGuides.h"

#include "solver/flow/FlowKind.h"

#include "vtkMath.h"

#include <cmath>

namespace vesicle
{
namespace
{

constexpr double shortest_arrow = 0.1; // of the longest
constexpr double line_end = 1;

Point3 point_of(const Vector3& v)
{
  return { v[0], v[1], v[2] };
}

/// The direction in which a profile varies.
Vector3 across_flow(const ImposedFlow::Profile& profile, const View& view)
{
  if (profile.across)
    return *profile.across;
  const Vector3 across = vector_of(view.toward_camera).cross(profile.along);
  return across.norm() > 1e-6 ? Vector3(across.normalized()) : vector_of(view.up);
}

/// Arrows of a flow at points `from` of the drawing, the longest of unit length; `at` are the same
/// points in the flow. A profile's arrows start from its line, others lie about their points.
Guide flow_arrows(const ImposedFlow& flow, const Points& at, const Points& from, bool profile)
{
  const Points velocity = flow.velocities(at);
  const double largest = velocity.rowwise().norm().maxCoeff();
  Guide guide{ "flow", {}, {} };
  for (Eigen::Index i = 0; i < at.rows(); ++i)
  {
    const Vector3 u = velocity.row(i).transpose();
    if (u.norm() <= shortest_arrow * largest || largest == 0)
      continue;
    const Vector3 arrow = u / largest, point = from.row(i).transpose();
    const Vector3 start = profile ? point : Vector3(point - 0.5 * arrow);
    guide.arrows.push_back({ point_of(start), point_of(start + arrow) });
  }
  return guide;
}

Guide profile_guide(const ImposedFlow& flow, const ImposedFlow::Profile& profile, const View& view)
{
  const Vector3 across = across_flow(profile, view);
  const Eigen::VectorXd places{ { -0.9, -0.6, -0.3, 0, 0.3, 0.6, 0.9 } };
  const Points from = places * across.transpose();
  const Points at = (profile.half_width * from).rowwise() + profile.center.transpose();
  Guide guide = flow_arrows(flow, at, from, true);
  guide.lines.push_back({ point_of(-line_end * across), point_of(line_end * across) });
  return guide;
}

Guide flow_guide(const ImposedFlow& flow, const View& view)
{
  if (const auto profile = flow.profile())
    return profile_guide(flow, *profile, view);
  constexpr double out = 0.6;
  Points around(4, 3);
  around << out, 0, 0, -out, 0, 0, 0, 0, out, 0, 0, -out;
  const Points velocity = flow.velocities(around);
  const bool uniform = (velocity.rowwise() - velocity.row(0)).isZero(0);
  const Points from = uniform ? Points(Points::Zero(1, 3)) : around;
  return flow_arrows(flow, from, from, false);
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
  // A field isn't known where a file of it is all that there is, nor everywhere.
  if (scene.flow && !is_from_file(scene.flow->kind()))
  {
    guides.push_back(flow_guide(*scene.flow, view));
  }
  return guides;
}

}
