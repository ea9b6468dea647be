#include "solver/stokes/PanelContrast.h"

#include "solver/ParallelFor.h"
#include "solver/stokes/NearRule.h"
#include "solver/stokes/PointSum.h"
#include "solver/stokes/kernels/StokesletKernel.h"

namespace vesicle
{

namespace
{

constexpr double factor = double_layer_factor * kernel_factor;

// X X·u X·n/r⁵.
Vector3 stresslet(const Vector3& X, const Vector3& u, const Vector3& n)
{
  const double square = X.squaredNorm();
  return X.dot(u) * X.dot(n) / (square * square * std::sqrt(square)) * X;
}

}

PanelContrast::PanelContrast(const SurfacePanels& panels) : panels_(panels)
{
  const auto rule = triangle_rule(fixed_panel_points);
  rows_per_panel_ = static_cast<int>(rule.size());
  const int rows = panels_.size() * rows_per_panel_;
  position_ = velocity_ = area_ = RowVectors(rows, 3);
  int row = 0;
  for (int panel = 0; panel < panels_.size(); ++panel)
    for (const TrianglePoint& p : rule)
    {
      const SurfacePanels::Motion motion = panels_.motion(panel, p.u, p.v);
      position_.row(row) = motion.position.transpose();
      velocity_.row(row) = motion.velocity.transpose();
      area_.row(row++) = factor * p.weight * motion.area.transpose();
    }
  strength_ = symmetric_products(velocity_, area_);
}

Vector3 PanelContrast::near_surface(const Vector3& x, std::span<const int> near, bool inside) const
{
  std::vector<SurfacePanels::Frame> nearest;
  std::size_t closest = 0;
  for (const int panel : near)
  {
    nearest.push_back(panels_.nearest(panel, x));
    if ((nearest.back().position - x).norm() < (nearest[closest].position - x).norm())
      closest = nearest.size() - 1;
  }
  const Vector3 there =
    panels_.motion(near[closest], nearest[closest].u, nearest[closest].v).velocity;
  Vector3 sum = Vector3::Zero();
  int row = 0;
  const auto add_rows = [&](int end)
  {
    for (; row < end; ++row)
      sum += stresslet(position_.row(row).transpose() - x, velocity_.row(row).transpose() - there,
        area_.row(row).transpose());
  };
  for (std::size_t k = 0; k < near.size(); ++k)
  {
    add_rows(near[k] * rows_per_panel_);
    row += rows_per_panel_;
    for_each_near_point(nearest[k], x,
      [&](double u, double v, double weight)
      {
        const SurfacePanels::Motion at = panels_.motion(near[k], u, v);
        const Vector3 X = at.position - x;
        if (X.squaredNorm() > 0)
          sum += factor * weight * stresslet(X, at.velocity - there, at.area);
      });
  }
  add_rows(static_cast<int>(position_.rows()));
  return inside ? Vector3(sum + there) : sum;
}

Points PanelContrast::at(const Points& points, const std::vector<unsigned char>& inside) const
{
  const auto n = static_cast<int>(points.rows());
  const AdjacencyList near = near_panels(panels_, points);
  std::vector<int> far_points;
  for (int i = 0; i < n; ++i)
    if (near.size(i) == 0)
      far_points.push_back(i);
  Points result(n, 3);
  if (!far_points.empty())
  {
    const Points targets = points(far_points, Eigen::all);
    Points made = Points::Zero(targets.rows(), 3);
    DirectPointSum<PointKind::stresslet>(position_, targets).add(strength_, 0, made);
    result(far_points, Eigen::all) = made;
  }
  parallel_for(n,
    [&](int i)
    {
      if (near.size(i) > 0)
        result.row(i) =
          near_surface(points.row(i).transpose(), { near.begin(i), near.end(i) }, inside[i] != 0)
            .transpose();
    });
  return result;
}

}
