#include "solver/mesh/remesh/EditableMesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vesicle
{

bool EditableMesh::faces_outward(int a, int b, int c) const
{
  const Vector3 area = (point(b) - point(a)).cross(point(c) - point(a));
  return area.dot(normal(a) + normal(b) + normal(c)) > 0;
}

double EditableMesh::length(int a, int b) const
{
  const double length = (points.row(a) - points.row(b)).norm();
  return sizes.size() == 0 ? length : 2 * length / (sizes[a] + sizes[b]);
}

double EditableMesh::steepness(int a, int b) const
{
  const Vector3 edge = (point(b) - point(a)).normalized();
  return std::max(std::abs(edge.dot(normal(a))), std::abs(edge.dot(normal(b))));
}

MeshQuality EditableMesh::quality() const
{
  return mesh_quality({ points, triangles });
}

std::vector<int> EditableMesh::valences() const
{
  std::vector<int> result(points.rows(), 0);
  for (const int i : triangles.reshaped())
    ++result[i];
  return result;
}

std::vector<int> EditableMesh::edges_between(double low, double high, const EdgeUses& edges) const
{
  const double rounding = 1e-10;
  std::vector<std::pair<double, int>> found;
  for (int e = 0; e < edges.size(); ++e)
  {
    const double d = length(edges[e].front().a, edges[e].front().b);
    if (d > low && d < high)
      found.emplace_back(std::round(d / rounding), e);
  }
  std::ranges::sort(found);
  std::vector<int> result;
  result.reserve(found.size());
  for (const auto& [rounded_length, e] : found)
    result.push_back(e);
  return result;
}

}
