#include "solver/mesh/EdgeUses.h"

#include <algorithm>
#include <tuple>

namespace vesicle
{

EdgeUses::EdgeUses(const Triangles& triangles)
{
  uses.reserve(3 * triangles.rows());
  for (int t = 0; t < triangles.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int from = triangles(t, k);
      const int to = triangles(t, (k + 1) % 3);
      if (from != to)
      {
        uses.push_back({ std::min(from, to), std::max(from, to), t, from < to });
      }
    }
  }
  std::sort(uses.begin(), uses.end(),
    [](const EdgeUse& l, const EdgeUse& r)
    { return std::tie(l.a, l.b, l.triangle) < std::tie(r.a, r.b, r.triangle); });
  const int n = static_cast<int>(uses.size());
  for (int i = 0; i < n; ++i)
  {
    if (i == 0 || uses[i].a != uses[i - 1].a || uses[i].b != uses[i - 1].b)
    {
      start.push_back(i);
    }
  }
  start.push_back(n);
}

namespace
{
/// The edge number of each triangle's side k (from corner k to k + 1).
Triangles edge_of_side(const EdgeUses& edges, const Triangles& triangles)
{
  Triangles result(triangles.rows(), 3);
  for (int e = 0; e < edges.size(); ++e)
  {
    for (const EdgeUse& use : edges[e])
    {
      const int from = use.forward ? use.a : use.b;
      const auto row = triangles.row(use.triangle);
      const int side = row[0] == from ? 0 : row[1] == from ? 1 : 2;
      result(use.triangle, side) = e;
    }
  }
  return result;
}
}

Triangles cut_in_four(const Triangles& triangles, const EdgeUses& edges, int points)
{
  const Triangles middle = edge_of_side(edges, triangles).array() + points;
  Triangles cut(4 * triangles.rows(), 3);
  for (int t = 0; t < triangles.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      cut.row(4 * t + k) << triangles(t, k), middle(t, k), middle(t, (k + 2) % 3);
    }
    cut.row(4 * t + 3) = middle.row(t);
  }
  return cut;
}

}
