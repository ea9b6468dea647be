#include "solver/mesh/EdgeUses.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace vesicle
{

EdgeUses::EdgeUses(const Triangles& triangles)
{
  uses_.reserve(3 * triangles.rows());
  for (int t = 0; t < triangles.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int from = triangles(t, k);
      const int to = triangles(t, (k + 1) % 3);
      if (from != to)
        uses_.push_back({ std::min(from, to), std::max(from, to), t, from < to });
    }
  }
  std::sort(uses_.begin(), uses_.end(),
    [](const EdgeUse& l, const EdgeUse& r)
    { return std::tie(l.a, l.b, l.triangle) < std::tie(r.a, r.b, r.triangle); });
  const int n = static_cast<int>(uses_.size());
  for (int i = 0; i < n; ++i)
    if (i == 0 || uses_[i].a != uses_[i - 1].a || uses_[i].b != uses_[i - 1].b)
      start_.push_back(i);
  start_.push_back(n);
}

int EdgeUses::find(int a, int b) const
{
  const std::pair wanted(std::min(a, b), std::max(a, b));
  const auto found = std::lower_bound(start_.begin(), start_.end() - 1, wanted,
    [&](int first, const auto& edge) { return std::pair(uses_[first].a, uses_[first].b) < edge; });
  return static_cast<int>(found - start_.begin());
}

std::vector<std::array<int, 3>> triangles_across(const Triangles& triangles)
{
  const EdgeUses edges(triangles);
  std::vector<std::array<int, 3>> across(triangles.rows());
  for (int e = 0; e < edges.size(); ++e)
    for (const EdgeUse& use : edges[e])
      for (int k = 0; k < 3; ++k)
        if (const int corner = triangles(use.triangle, k); corner != use.a && corner != use.b)
          across[use.triangle][k] = edges[e].front().triangle == use.triangle
            ? edges[e].back().triangle
            : edges[e].front().triangle;
  return across;
}

}
