#include "solver/mesh/EdgeUses.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace vesicle
{

namespace
{

/// Calls visit(use) with the three sides of each triangle; those from a point to itself are none.
template<typename Visit>
void for_each_side(const Triangles& triangles, Visit visit)
{
  for (int t = 0; t < triangles.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int from = triangles(t, k);
      const int to = triangles(t, (k + 1) % 3);
      if (from != to)
        visit(EdgeUse{ std::min(from, to), std::max(from, to), t, from < to });
    }
  }
}

}

// By a through counting, in linear time; each point then has a few to be sorted by b and triangle.
EdgeUses::EdgeUses(const Triangles& triangles)
{
  const int points = triangles.size() > 0 ? triangles.maxCoeff() + 1 : 0;
  std::vector<int> place(points + 1, 0); // of the next side of each
  for_each_side(triangles, [&](const EdgeUse& use) { ++place[use.a + 1]; });
  std::partial_sum(place.begin(), place.end(), place.begin());
  uses_.resize(place.back());
  for_each_side(triangles, [&](const EdgeUse& use) { uses_[place[use.a]++] = use; });
  for (int a = 0, first = 0; a < points; ++a)
  {
    std::sort(uses_.begin() + first, uses_.begin() + place[a],
      [](const EdgeUse& l, const EdgeUse& r)
      { return std::tie(l.b, l.triangle) < std::tie(r.b, r.triangle); });
    first = place[a];
  }
  const int n = static_cast<int>(uses_.size());
  start_.reserve(n / 2 + 1);
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
