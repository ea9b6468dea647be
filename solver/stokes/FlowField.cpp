#include "solver/stokes/FlowField.h"

#include "solver/ParallelFor.h"
#include "solver/stokes/kernels/StokesletKernel.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace vesicle
{

namespace
{

constexpr int lanes = stokeslet_lanes;
// Points of the fixed rule, and the distance from a panel's centre, in its radii, from which on it
// is used.
constexpr int fixed_points = 12;
constexpr double near_radii = 2.5;
// Distances below this part of the largest ρ are as good as 0: what the rule then doesn't resolve
// is a peak that carries that part of the panel's velocity.
constexpr double least_distance = 1e-4;
// A side that passes x* at less than this part of its length bounds a sector without area.
constexpr double least_height = 1e-9;
constexpr int max_gauss_points = 48;

/// Gauss points for an integrand that is smooth over a unit length of the transformed variable.
const GaussRule& gauss_rule(double length)
{
  static const auto rules = []
  {
    std::array<GaussRule, max_gauss_points + 1> all;
    for (int n = 1; n <= max_gauss_points; ++n)
      all[n] = gauss_legendre(n);
    return all;
  }();
  const int points = 5 + static_cast<int>(std::ceil(1.5 * length));
  return rules[std::min(points, max_gauss_points)];
}

// G f of a force f at X from the target.
Vector3 stokeslet(const Vector3& X, const Vector3& f)
{
  const double over_r = 1 / X.norm();
  return over_r * f + (over_r * over_r * over_r * X.dot(f)) * X;
}

}

FlowField::FlowField(SurfacePanels panels) : panels_(std::move(panels))
{
  const auto rule = triangle_rule(fixed_points);
  rows_per_panel_ = static_cast<int>(rule.size());
  const int rows = panels_.size() * rows_per_panel_;
  position_ = force_ = normal_ = RowVectors(rows, 3);
  weight_.resize(rows);
  int row = 0;
  for (int panel = 0; panel < panels_.size(); ++panel)
    for (const TrianglePoint& p : rule)
    {
      const SurfacePanels::Sample sample = panels_.sample(panel, p.u, p.v);
      position_.row(row) = sample.position.transpose();
      force_.row(row) = sample.force.transpose();
      normal_.row(row) = panels_.frame(panel, p.u, p.v).cross().transpose();
      weight_[row++] = kernel_factor * p.weight;
    }
}

Vector3 FlowField::near_velocity(
  int panel, const SurfacePanels::Frame& nearest, const Vector3& x) const
{
  // The tangent plane at x*, in which the panel is nearly a triangle and ρ the distance.
  const Vector3 e1 = nearest.tangent_u.normalized(), n = nearest.cross().normalized();
  const Vector3 e2 = n.cross(e1);
  Eigen::Matrix2d to_plane;
  to_plane << nearest.tangent_u.dot(e1), nearest.tangent_v.dot(e1), nearest.tangent_u.dot(e2),
    nearest.tangent_v.dot(e2);
  const Eigen::Matrix2d to_domain = to_plane.inverse();
  const double over_jacobian = to_domain.determinant();
  const Eigen::Vector2d here(nearest.u, nearest.v);
  const Eigen::Vector2d corner[] = { to_plane * -here, to_plane * (Eigen::Vector2d(1, 0) - here),
    to_plane * (Eigen::Vector2d(0, 1) - here) };
  const double distance = (nearest.position - x).norm();

  Vector3 velocity = Vector3::Zero();
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
    const GaussRule& angular = gauss_rule(last - first);
    for (std::size_t i = 0; i < angular.node.size(); ++i)
    {
      const double w = first + (last - first) * angular.node[i], reach = height * std::cosh(w);
      const Eigen::Vector2d direction = (foot + height * std::sinh(w) * along) / reach;
      const double d = std::max(distance, least_distance * reach);
      const double longest = std::asinh(reach / d);
      const GaussRule& radial = gauss_rule(longest);
      const double sector = (last - first) * angular.weight[i] / std::cosh(w) * over_jacobian;
      for (std::size_t j = 0; j < radial.node.size(); ++j)
      {
        const double t = longest * radial.node[j], rho = d * std::sinh(t);
        const Eigen::Vector2d uv = here + to_domain * (rho * direction);
        const SurfacePanels::Sample s = panels_.sample(panel, uv[0], uv[1]);
        const double weight = sector * longest * radial.weight[j] * rho * d * std::cosh(t);
        velocity += weight * stokeslet(s.position - x, s.force);
      }
    }
  }
  return kernel_factor * velocity;
}

void FlowField::at_group(const Points& points, int first, int count, Flow& flow) const
{
  std::array<double, 3 * lanes> targets;
  for (int lane = 0; lane < lanes; ++lane)
    for (int c = 0; c < 3; ++c)
      targets[c * lanes + lane] = points(first + std::min(lane, count - 1), c);

  std::array<Vector3, lanes> near;
  near.fill(Vector3::Zero());
  std::array<double, lanes> least, side;
  least.fill(INFINITY);
  const ForceSources sources{ { position_.col(0).data(), position_.col(1).data(),
                                position_.col(2).data(), weight_.data(), nullptr, nullptr, nullptr,
                                nullptr },
    force_.data(), normal_.data(), static_cast<int>(weight_.size()) };
  std::array<double, 4 * lanes> sum{};
  std::array<double, lanes> all;
  all.fill(1);
  int row = 0;
  for (int panel = 0; panel < panels_.size(); ++panel)
  {
    std::array<double, lanes> mask;
    const Vector3& center = panels_.center(panel);
    const double radius = near_radii * panels_.radius(panel);
    double far = lanes;
    for (int lane = 0; lane < lanes; ++lane)
    {
      const double x = targets[lane] - center.x(), y = targets[lanes + lane] - center.y(),
                   z = targets[2 * lanes + lane] - center.z();
      mask[lane] = x * x + y * y + z * z < radius * radius ? 0 : 1;
      far += mask[lane] - 1;
    }
    if (far == lanes)
      continue;
    // The rows up to here are far from all.
    const int begin = panel * rows_per_panel_, end = begin + rows_per_panel_;
    add_velocities(sources, row, begin, targets.data(), all.data(), sum.data());
    add_velocities(sources, begin, end, targets.data(), mask.data(), sum.data());
    row = end;
    for (int lane = 0; lane < count; ++lane)
    {
      if (mask[lane] != 0)
        continue;
      const Vector3 x = points.row(first + lane).transpose();
      const SurfacePanels::Frame nearest = panels_.nearest(panel, x);
      near[lane] += near_velocity(panel, nearest, x);
      const Vector3 away = x - nearest.position;
      if (away.norm() < least[lane])
      {
        least[lane] = away.norm();
        side[lane] = away.dot(nearest.cross());
      }
    }
  }
  add_velocities(
    sources, row, static_cast<int>(weight_.size()), targets.data(), all.data(), sum.data());

  for (int lane = 0; lane < count; ++lane)
  {
    flow.velocity.row(first + lane) = near[lane].transpose();
    for (int c = 0; c < 3; ++c)
      flow.velocity(first + lane, c) += sum[c * lanes + lane];
    // Near the surface by the side of the nearest point; elsewhere by the solid angle, 4π or 0.
    const double solid_angle = sum[3 * lanes + lane] / kernel_factor;
    flow.inside[first + lane] =
      std::isfinite(least[lane]) ? side[lane] < 0 : solid_angle > 2 * std::numbers::pi;
  }
}

FlowField::Flow FlowField::at(const Points& points) const
{
  const int n = static_cast<int>(points.rows());
  Flow flow{ Points(n, 3), std::vector<unsigned char>(n) };
  parallel_for((n + lanes - 1) / lanes,
    [&](int group) { at_group(points, group * lanes, std::min(lanes, n - group * lanes), flow); });
  return flow;
}

}
