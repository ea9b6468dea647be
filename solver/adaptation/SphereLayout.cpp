#include "solver/adaptation/SphereLayout.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vesicle
{

// Vertices by height, the highest first.
static std::vector<int> from_above(const Eigen::VectorXd& heights)
{
  std::vector<int> order(heights.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::ranges::greater(), [&](int i) { return heights[i]; });
  return order;
}

SphereLayout::SphereLayout(const TriangleMesh& surface, const Eigen::VectorXd& triangles)
  : triangles_(triangles), embedding_(surface, triangles)
{
  share_out();
}

void SphereLayout::share_out()
{
  const Eigen::VectorXd z = embedding_.directions().col(2);
  height_ = { 1 };
  share_ = { 0 };
  double above = 0;
  const double all = triangles_.sum();
  for (const int i : from_above(z))
  {
    height_.push_back(z[i]);
    share_.push_back((above + triangles_[i] / 2) / all);
    above += triangles_[i];
  }
  height_.push_back(-1);
  share_.push_back(1);
}

double SphereLayout::height_at(double share) const
{
  const auto i = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(
    std::ranges::lower_bound(share_, share) - share_.begin(), 1, std::ssize(share_) - 1));
  const double part = (share - share_[i - 1]) / (share_[i] - share_[i - 1]);
  return height_[i - 1] + part * (height_[i] - height_[i - 1]);
}

void SphereLayout::next_axis()
{
  embedding_.permute_axes();
  share_out();
}

PlacedMesh SphereLayout::lay(const SphereMesh& sphere) const
{
  constexpr double same_height = 1e-6;
  const Eigen::VectorXd heights = sphere.directions.col(2);
  const auto count = static_cast<int>(heights.size());
  const std::vector<int> order = from_above(heights);
  PlacedMesh laid{ std::vector<SurfacePlace>(count), sphere.triangles };
  int near = 0;
  for (int first = 0, last; first < count; first = last)
  {
    const double top = heights[order[first]];
    for (last = first + 1; last < count && heights[order[last]] > top - same_height;)
      ++last;
    const double z = height_at((first + last) / 2. / count), r = std::sqrt(std::max(0., 1 - z * z));
    for (int k = first; k < last; ++k)
    {
      const auto d = sphere.directions.row(order[k]);
      const double around = std::hypot(d[0], d[1]);
      const Vector3 direction = around > same_height
        ? Vector3(r * d[0] / around, r * d[1] / around, z)
        : Vector3(0, 0, d[2] > 0 ? 1 : -1);
      SurfacePlace& place = laid.places[order[k]];
      place = embedding_.place(direction, near);
      near = place.element;
    }
  }
  return laid;
}

}
