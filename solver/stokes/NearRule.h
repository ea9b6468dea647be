#pragma once
// Quadrature on a panel for a point near it or on it: polar coordinates (ρ, θ) about the panel's
// nearest point x*, with ρ = d sinh t, d = |x − x*|, which takes a peak of width d out of the
// integrand (FlowField.h has the sources).

#include "solver/mesh/Connectivity.h"
#include "solver/stokes/SurfacePanels.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>

namespace vesicle
{

/// Farther than near_panel_radii of a panel's radii from its centre a fixed rule of that many points
/// does.
inline constexpr int fixed_panel_points = 12;
inline constexpr double near_panel_radii = 2.5;

/// The panels near each point, ascending.
AdjacencyList near_panels(const SurfacePanels& panels, const Points& points);

/// Gauss points for an integrand that is smooth over a unit length of the transformed variable.
const GaussRule& near_gauss_rule(double length);

/// add(u, v, weight) at the points of the rule for x on the panel of which `nearest` is the point
/// nearest to x; weights are of du dv.
template<class Add>
void for_each_near_point(const SurfacePanels::Frame& nearest, const Vector3& x, Add add)
{
  // Distances below this part of the largest ρ are as good as 0: what the rule then doesn't resolve
  // is a peak that carries that part of the panel's velocity.
  constexpr double least_distance = 1e-4;
  // A side that passes x* at less than this part of its length bounds a sector without area.
  constexpr double least_height = 1e-9;
  // The tangent plane at x*, in which the panel is nearly a triangle and ρ the distance.
  const Vector3 e1 = nearest.tangent_u.normalized(), n = nearest.cross().normalized();
  const Vector3 e2 = n.cross(e1);
  Eigen::Matrix2d to_plane;
  to_plane << nearest.tangent_u.dot(e1), nearest.tangent_v.dot(e1), nearest.tangent_u.dot(e2),
    nearest.tangent_v.dot(e2);
  const Eigen::Matrix2d to_domain = to_plane.inverse();
  const double over_jacobian = to_domain.determinant();
  const Eigen::Vector2d here(nearest.u, nearest.v);
  const std::array<Eigen::Vector2d, 3> corner{ to_plane * -here,
    to_plane * (Eigen::Vector2d(1, 0) - here), to_plane * (Eigen::Vector2d(0, 1) - here) };
  const double distance = (nearest.position - x).norm();

  for (int side = 0; side < 3; ++side)
  {
    // The sector between x* and a side: its height, and the side's ends along it from the foot.
    const Eigen::Vector2d &a = corner[side], &b = corner[(side + 1) % 3];
    const double length = (b - a).norm();
    const Eigen::Vector2d along = (b - a) / length;
    const double height = a.x() * along.y() - a.y() * along.x();
    if (height < least_height * length)
      continue;
    const Eigen::Vector2d foot = a - a.dot(along) * along;
    const double first = std::asinh(a.dot(along) / height),
                 last = std::asinh(b.dot(along) / height);
    const GaussRule& angular = near_gauss_rule(last - first);
    for (std::size_t i = 0; i < angular.node.size(); ++i)
    {
      const double w = first + (last - first) * angular.node[i], reach = height * std::cosh(w);
      const Eigen::Vector2d direction = (foot + height * std::sinh(w) * along) / reach;
      const double d = std::max(distance, least_distance * reach);
      const double longest = std::asinh(reach / d);
      const GaussRule& radial = near_gauss_rule(longest);
      const double sector = (last - first) * angular.weight[i] / std::cosh(w) * over_jacobian;
      for (std::size_t j = 0; j < radial.node.size(); ++j)
      {
        const double t = longest * radial.node[j], rho = d * std::sinh(t);
        const Eigen::Vector2d uv = here + to_domain * (rho * direction);
        add(uv[0], uv[1], sector * longest * radial.weight[j] * rho * d * std::cosh(t));
      }
    }
  }
}

}
