#include "solver/mesh/remesh/EdgeSplits.h"

#include "solver/mesh/Refinement.h"

#include <algorithm>
#include <utility>

namespace vesicle
{

namespace
{
/// An edge isn't cut where one part would be shorter than this part of it.
constexpr double least_part = 0.25;

/// Near the middle of the edge's cubic Hermite arc, whose tangents at the ends are the edge itself
/// less its normal part: also where the surface turns by 90° and more.
PointWithNormal middle_of_edge(
  const EditableMesh& mesh, const SurfaceProjection& surface, int a, int b)
{
  const Vector3 edge = mesh.point(b) - mesh.point(a);
  const Vector3 bulge =
    edge.dot(mesh.normal(b)) * mesh.normal(b) - edge.dot(mesh.normal(a)) * mesh.normal(a);
  return surface((mesh.point(a) + mesh.point(b)) / 2 + bulge / 8,
    (mesh.normal(a) + mesh.normal(b)).normalized());
}

struct Split
{
  int edge;
  PointWithNormal middle;
};

/// Which edges are cut, and where: no two at one triangle.
std::vector<Split> choose_splits(const EditableMesh& mesh, const EdgeUses& edges,
  const SurfaceProjection& surface, double length, int most)
{
  std::vector<Split> chosen;
  std::vector<bool> changed(mesh.triangles.rows(), false);
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<int> longest_first = mesh.edges_between(length, infinity, edges);
  std::reverse(longest_first.begin(), longest_first.end());
  for (const int e : longest_first)
  {
    const auto [a, b, left, forward] = edges[e].front();
    const int right = edges[e].back().triangle;
    if (static_cast<int>(chosen.size()) == most || changed[left] || changed[right])
      continue;
    const PointWithNormal middle = middle_of_edge(mesh, surface, a, b);
    const double nearer =
      std::min((middle.point - mesh.point(a)).norm(), (middle.point - mesh.point(b)).norm());
    if (nearer > least_part * (mesh.point(b) - mesh.point(a)).norm())
    {
      changed[left] = changed[right] = true;
      chosen.push_back({ e, middle });
    }
  }
  return chosen;
}
}

int split_edges(EditableMesh& mesh, const SurfaceProjection& surface, double length, int most)
{
  const EdgeUses edges(mesh.triangles);
  const std::vector<Split> splits = choose_splits(mesh, edges, surface, length, most);
  int point = static_cast<int>(mesh.points.rows());
  int triangle = static_cast<int>(mesh.triangles.rows());
  const int count = static_cast<int>(splits.size());
  mesh.points.conservativeResize(point + count, Eigen::NoChange);
  mesh.normals.conservativeResize(point + count, Eigen::NoChange);
  if (mesh.sizes.size() > 0)
    mesh.sizes.conservativeResize(point + count);
  mesh.triangles.conservativeResize(triangle + 2 * count, Eigen::NoChange);
  for (const auto& [edge, middle] : splits)
  {
    mesh.points.row(point) = middle.point;
    mesh.normals.row(point) = middle.normal;
    if (mesh.sizes.size() > 0)
      mesh.sizes[point] =
        (mesh.sizes[edges[edge].front().a] + mesh.sizes[edges[edge].front().b]) / 2;
    for (const EdgeUse& use : edges[edge])
    {
      auto near_a = mesh.triangles.row(use.triangle), near_b = mesh.triangles.row(triangle++);
      near_b = near_a;
      near_b = (near_b.array() == use.a).select(point, near_b).eval();
      near_a = (near_a.array() == use.b).select(point, near_a).eval();
    }
    ++point;
  }
  return count;
}

void refine(EditableMesh& mesh, const SurfaceProjection& surface)
{
  const EdgeUses edges(mesh.triangles);
  const int points = static_cast<int>(mesh.points.rows());
  mesh.points.conservativeResize(points + edges.size(), Eigen::NoChange);
  mesh.normals.conservativeResize(points + edges.size(), Eigen::NoChange);
  for (int e = 0; e < edges.size(); ++e)
  {
    const EdgeUse& use = edges[e].front();
    const PointWithNormal middle = middle_of_edge(mesh, surface, use.a, use.b);
    mesh.points.row(points + e) = middle.point;
    mesh.normals.row(points + e) = middle.normal;
  }
  mesh.triangles = refined(mesh.triangles, edges, points);
}

}
