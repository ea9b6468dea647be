#include "solver/mesh/Connectivity.h"

#include "solver/mesh/EdgeUses.h"

#include <utility>

namespace vesicle
{

namespace
{
/// Sorts pairs (list, entry), given with ascending entries in each list, into compressed lists.
AdjacencyList compress(const std::vector<std::pair<int, int>>& pairs, int lists)
{
  AdjacencyList result;
  result.start.assign(lists + 1, 0);
  for (const auto& [list, entry] : pairs)
    ++result.start[list + 1];
  for (int i = 0; i < lists; ++i)
    result.start[i + 1] += result.start[i];
  std::vector<int> next(result.start.begin(), result.start.end() - 1);
  result.item.resize(pairs.size());
  for (const auto& [list, entry] : pairs)
    result.item[next[list]++] = entry;
  return result;
}

AdjacencyList triangles_around(const Triangles& triangles, int points)
{
  std::vector<std::pair<int, int>> pairs;
  pairs.reserve(3 * triangles.rows());
  for (int t = 0; t < triangles.rows(); ++t)
  {
    const auto [a, b, c] = std::array{ triangles(t, 0), triangles(t, 1), triangles(t, 2) };
    pairs.emplace_back(a, t);
    if (b != a)
      pairs.emplace_back(b, t);
    if (c != a && c != b)
      pairs.emplace_back(c, t);
  }
  return compress(pairs, points);
}

/// The edges are sorted by (a, b), so that all smaller neighbours of a vertex, and then all larger
/// ones, come in ascending order.
AdjacencyList neighbours_along(const std::vector<std::array<int, 2>>& edges, int points)
{
  std::vector<std::pair<int, int>> pairs;
  pairs.reserve(2 * edges.size());
  for (const auto& [a, b] : edges)
    pairs.emplace_back(b, a);
  for (const auto& [a, b] : edges)
    pairs.emplace_back(a, b);
  return compress(pairs, points);
}
}

Connectivity::Connectivity(const Triangles& triangles, int points)
  : vertex_triangles(triangles_around(triangles, points))
{
  const EdgeUses uses(triangles);
  edges.reserve(uses.size());
  edge_triangles.reserve(uses.size());
  for (int e = 0; e < uses.size(); ++e)
  {
    edges.push_back({ uses[e].front().a, uses[e].front().b });
    edge_triangles.push_back(static_cast<int>(uses[e].size()));
  }
  vertex_neighbours = neighbours_along(edges, points);
}

double mean_edge(const Points& points, const AdjacencyList& neighbours)
{
  double sum = 0;
  for (int i = 0; i < points.rows(); ++i)
    for (const int* j = neighbours.begin(i); j != neighbours.end(i); ++j)
      sum += (points.row(*j) - points.row(i)).norm();
  return neighbours.item.empty() ? 0 : sum / static_cast<double>(neighbours.item.size());
}

std::vector<char> border_vertices(const Connectivity& connectivity)
{
  std::vector<char> border(connectivity.vertex_neighbours.start.size() - 1, 0);
  for (std::size_t e = 0; e < connectivity.edges.size(); ++e)
    if (connectivity.edge_triangles[e] != 2)
      for (const int end : connectivity.edges[e])
        border[end] = 1;
  return border;
}

}
