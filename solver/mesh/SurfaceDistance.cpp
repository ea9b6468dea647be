#include "solver/mesh/SurfaceDistance.h"

#include "solver/mesh/TriangleTree.h"

#include <cmath>
#include <vector>

namespace vesicle
{
namespace
{

struct Sums
{
  double area = 0, distance = 0, square = 0;
};

/// From the corners, found once each, and the centroids.
void add_distances(
  const TriangleMesh& from, const TriangleMesh& to, Sums& sums, SurfaceDistance& result)
{
  const TriangleTree tree(to);
  const auto distance_of = [&](const Vector3& x)
  {
    const double distance = std::sqrt(tree.nearest(x).squared_distance);
    if (distance > result.largest)
    {
      result.largest = distance;
      result.place = x;
    }
    return distance;
  };
  const auto add = [&](double area, double distance)
  {
    sums.area += area;
    sums.distance += area * distance;
    sums.square += area * distance * distance;
  };
  std::vector<double> at_point(from.points.rows(), -1);
  for (int t = 0; t < from.triangles.rows(); ++t)
  {
    const auto [a, b, c] = corners(from, t);
    const double area = (b - a).cross(c - a).norm() / 2;
    add(0.75 * area, distance_of((a + b + c) / 3));
    for (const int corner : from.triangles.row(t))
    {
      if (at_point[corner] < 0)
        at_point[corner] = distance_of(from.points.row(corner));
      add(area / 12, at_point[corner]);
    }
  }
}

}

SurfaceDistance surface_distance(const TriangleMesh& a, const TriangleMesh& b)
{
  SurfaceDistance result;
  Sums sums;
  add_distances(a, b, sums, result);
  add_distances(b, a, sums, result);
  if (sums.area > 0)
  {
    result.mean = sums.distance / sums.area;
    result.rms = std::sqrt(sums.square / sums.area);
  }
  return result;
}

}
