#include "solver/mesh/repair/Holes.h"

#include "solver/mesh/EdgeUses.h"
#include "solver/mesh/repair/Components.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace vesicle
{
namespace
{

/// Of each point on a border, the one before it as its triangle runs; −1 elsewhere.
std::vector<int> predecessors(const TriangleMesh& mesh)
{
  const EdgeUses uses(mesh.triangles);
  std::vector<int> before(mesh.points.rows(), -1);
  for (int e = 0; e < uses.size(); ++e)
    if (uses[e].size() == 1)
    {
      const EdgeUse& use = uses[e].front();
      before[use.forward ? use.b : use.a] = use.forward ? use.a : use.b;
    }
  return before;
}

Hole hole_from(const TriangleMesh& mesh, int start, std::vector<int>& before)
{
  Hole hole;
  for (int point = start; point >= 0 && before[point] >= 0;)
  {
    const int next = std::exchange(before[point], -1);
    hole.points.push_back(point);
    hole.length += (mesh.points.row(point) - mesh.points.row(next)).norm();
    point = next;
  }
  return hole;
}

void fill(TriangleMesh& mesh, const Hole& hole)
{
  const auto first = mesh.triangles.rows();
  const int sides = static_cast<int>(hole.points.size());
  if (sides == 3)
  {
    mesh.triangles.conservativeResize(first + 1, Eigen::NoChange);
    mesh.triangles.row(first) << hole.points[0], hole.points[1], hole.points[2];
    return;
  }
  const int middle = static_cast<int>(mesh.points.rows());
  const Eigen::RowVector3d centre = mesh.points(hole.points, Eigen::all).colwise().mean();
  mesh.points.conservativeResize(middle + 1, Eigen::NoChange);
  mesh.points.row(middle) = centre;
  mesh.triangles.conservativeResize(first + sides, Eigen::NoChange);
  for (int i = 0; i < sides; ++i)
    mesh.triangles.row(first + i) << hole.points[i], hole.points[(i + 1) % sides], middle;
}

}

std::vector<Hole> holes_of(const TriangleMesh& mesh)
{
  std::vector<double> area(mesh.points.rows(), 0); // of the component that the point is in
  for (const Component& component : components_of(mesh))
    for (const int t : component.triangles)
      for (const int corner : mesh.triangles.row(t))
        area[corner] = component.area;
  std::vector<int> before = predecessors(mesh);
  std::vector<Hole> holes;
  for (int point = 0; point < mesh.points.rows(); ++point)
    if (before[point] >= 0)
    {
      Hole hole = hole_from(mesh, point, before);
      hole.size = hole.length / std::sqrt(std::numbers::pi * area[point]);
      holes.push_back(std::move(hole));
    }
  return holes;
}

int fill_holes(TriangleMesh& mesh, double largest)
{
  int filled = 0;
  for (const Hole& hole : holes_of(mesh))
    if (hole.points.size() >= 3 && hole.size <= largest)
    {
      fill(mesh, hole);
      ++filled;
    }
  return filled;
}

}
