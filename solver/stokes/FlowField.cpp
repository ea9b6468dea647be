#include "solver/stokes/FlowField.h"

#include "solver/ParallelFor.h"
#include "solver/stokes/NearRule.h"
#include "solver/stokes/kernels/StokesletKernel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace vesicle
{

namespace
{

constexpr int lanes = stokeslet_lanes;

// G f of a force f at X from the target.
Vector3 stokeslet(const Vector3& X, const Vector3& f)
{
  const double over_r = 1 / X.norm();
  return over_r * f + (over_r * over_r * over_r * X.dot(f)) * X;
}

// Of `count` points from `first` on, ascending.
std::vector<int> panels_near_any(const AdjacencyList& near, int first, int count)
{
  std::vector<int> panels(near.begin(first), near.end(first + count - 1));
  std::sort(panels.begin(), panels.end());
  panels.erase(std::unique(panels.begin(), panels.end()), panels.end());
  return panels;
}

}

FlowField::FlowField(SurfacePanels panels) : panels_(std::move(panels))
{
  const auto rule = triangle_rule(fixed_panel_points);
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
  Vector3 velocity = Vector3::Zero();
  for_each_near_point(nearest, x,
    [&](double u, double v, double weight)
    {
      const SurfacePanels::Sample s = panels_.sample(panel, u, v);
      velocity += weight * stokeslet(s.position - x, s.force);
    });
  return kernel_factor * velocity;
}

void FlowField::at_group(
  const Points& points, const AdjacencyList& near, int first, int count, Flow& flow) const
{
  std::array<double, 3 * lanes> targets;
  for (int lane = 0; lane < lanes; ++lane)
    for (int c = 0; c < 3; ++c)
      targets[c * lanes + lane] = points(first + std::min(lane, count - 1), c);

  std::array<Vector3, lanes> velocity;
  velocity.fill(Vector3::Zero());
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
  for (const int panel : panels_near_any(near, first, count))
  {
    std::array<double, lanes> mask = all;
    for (int lane = 0; lane < lanes; ++lane)
    {
      const int i = first + std::min(lane, count - 1);
      if (std::binary_search(near.begin(i), near.end(i), panel))
        mask[lane] = 0;
    }
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
      velocity[lane] += near_velocity(panel, nearest, x);
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
    flow.velocity.row(first + lane) = velocity[lane].transpose();
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
  const AdjacencyList near = near_panels(panels_, points);
  parallel_for((n + lanes - 1) / lanes,
    [&](int group)
    { at_group(points, near, group * lanes, std::min(lanes, n - group * lanes), flow); });
  return flow;
}

}
