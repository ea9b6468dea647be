#include "solver/mesh/repair/Components.h"

#include "solver/mesh/DisjointSets.h"
#include "solver/mesh/repair/Cleaning.h"

#include <algorithm>
#include <map>

namespace vesicle
{

std::vector<Component> components_of(const TriangleMesh& mesh)
{
  DisjointSets sets(static_cast<int>(mesh.points.rows()));
  for (const auto& row : mesh.triangles.rowwise())
  {
    sets.unite(row[0], row[1]);
    sets.unite(row[0], row[2]);
  }
  std::map<int, std::size_t> number;
  std::vector<Component> components;
  for (int t = 0; t < mesh.triangles.rows(); ++t)
  {
    const auto [place, is_new] =
      number.try_emplace(sets.find(mesh.triangles(t, 0)), components.size());
    if (is_new)
      components.emplace_back();
    Component& component = components[place->second];
    const auto [a, b, c] = corners(mesh, t);
    component.triangles.push_back(t);
    component.area += (b - a).cross(c - a).norm() / 2;
  }
  return components;
}

std::vector<int> points_of(const TriangleMesh& mesh, const std::vector<int>& triangles)
{
  std::vector<int> points;
  points.reserve(3 * triangles.size());
  for (const int t : triangles)
    points.insert(points.end(), mesh.triangles.row(t).begin(), mesh.triangles.row(t).end());
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

TriangleMesh part_of(const TriangleMesh& mesh, const std::vector<int>& triangles)
{
  TriangleMesh part{ mesh.points, mesh.triangles(triangles, Eigen::all) };
  drop_unused_points(part);
  return part;
}

}
