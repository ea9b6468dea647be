#include "solver/mesh/Refinement.h"

namespace vesicle
{

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

Triangles refined(const Triangles& triangles, const EdgeUses& edges, int points)
{
  const Triangles middle = edge_of_side(edges, triangles).array() + points;
  Triangles cut(4 * triangles.rows(), 3);
  for (int t = 0; t < triangles.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
      cut.row(4 * t + k) << triangles(t, k), middle(t, k), middle(t, (k + 2) % 3);
    cut.row(4 * t + 3) = middle.row(t);
  }
  return cut;
}

}
