#include "solver/mesh/repair/Cleaning.h"

#include "solver/mesh/MergedPoints.h"

#include <algorithm>
#include <set>

namespace vesicle
{
namespace
{

/// The same for the three ways to begin with a corner.
std::array<int, 3> from_least_corner(std::array<int, 3> triangle)
{
  std::rotate(triangle.begin(), std::ranges::min_element(triangle), triangle.end());
  return triangle;
}

}

int merge_points(TriangleMesh& mesh, double distance)
{
  const MergedPoints merged = merged_points(mesh.points, distance);
  const auto before = mesh.points.rows();
  mesh.points = kept_points(mesh.points, merged);
  for (int& corner : mesh.triangles.reshaped())
    corner = merged.number[corner];
  return static_cast<int>(before - mesh.points.rows());
}

DroppedTriangles drop_idle_triangles(TriangleMesh& mesh)
{
  DroppedTriangles dropped;
  std::set<std::array<int, 3>> seen;
  std::vector<bool> kept;
  for (const auto& row : mesh.triangles.rowwise())
  {
    const bool flat = row[0] == row[1] || row[1] == row[2] || row[2] == row[0];
    const bool is_new = !flat && seen.insert(from_least_corner({ row[0], row[1], row[2] })).second;
    dropped.without_area += flat;
    dropped.doubled += !flat && !is_new;
    kept.push_back(is_new);
  }
  keep_triangles(mesh, kept);
  return dropped;
}

void keep_triangles(TriangleMesh& mesh, const std::vector<bool>& kept)
{
  int next = 0;
  for (int t = 0; t < mesh.triangles.rows(); ++t)
    if (kept[t])
      mesh.triangles.row(next++) = mesh.triangles.row(t).eval();
  mesh.triangles.conservativeResize(next, Eigen::NoChange);
}

int drop_unused_points(TriangleMesh& mesh)
{
  std::vector<int> number(mesh.points.rows(), -1), kept;
  for (const int corner : mesh.triangles.reshaped())
    number[corner] = 0;
  for (int i = 0; i < mesh.points.rows(); ++i)
    if (number[i] == 0)
    {
      number[i] = static_cast<int>(kept.size());
      kept.push_back(i);
    }
  const auto before = mesh.points.rows();
  mesh.points = mesh.points(kept, Eigen::all).eval();
  for (int& corner : mesh.triangles.reshaped())
    corner = number[corner];
  return static_cast<int>(before - mesh.points.rows());
}

}
