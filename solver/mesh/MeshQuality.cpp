#include "solver/mesh/MeshQuality.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace vesicle
{

namespace
{
/// Smallest corner angle in degrees; atan2 keeps its digits for needles, where acos loses them.
double smallest_angle(const std::array<Vector3, 3>& corner)
{
  const double twice_area = (corner[1] - corner[0]).cross(corner[2] - corner[0]).norm();
  double smallest = std::numbers::pi;
  for (int k = 0; k < 3; ++k)
  {
    const Vector3 u = corner[(k + 1) % 3] - corner[k];
    const Vector3 w = corner[(k + 2) % 3] - corner[k];
    smallest = std::min(smallest, std::atan2(twice_area, u.dot(w)));
  }
  return smallest * 180 / std::numbers::pi;
}
}

MeshQuality mesh_quality(const TriangleMesh& mesh)
{
  MeshQuality quality;
  const int triangles = static_cast<int>(mesh.triangles.rows());
  if (triangles == 0)
    return quality;
  quality.min_angle_deg = std::numeric_limits<double>::infinity();
  quality.min_edge = std::numeric_limits<double>::infinity();
  double longest = 0;
  for (int t = 0; t < triangles; ++t)
  {
    const std::array<Vector3, 3> corner = corners(mesh, t);
    for (int k = 0; k < 3; ++k)
    {
      const double length = (corner[(k + 1) % 3] - corner[k]).norm();
      quality.min_edge = std::min(quality.min_edge, length);
      longest = std::max(longest, length);
      quality.mean_edge += length / (3.0 * triangles);
    }
    const double angle = smallest_angle(corner);
    if (angle < quality.min_angle_deg)
    {
      quality.min_angle_deg = angle;
      quality.worst_triangle = t;
    }
  }
  quality.edge_ratio =
    quality.min_edge > 0 ? longest / quality.min_edge : std::numeric_limits<double>::infinity();
  return quality;
}

}
