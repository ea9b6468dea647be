#include "solver/dynamics/MeshMotion.h"

#include <algorithm>

namespace vesicle
{

namespace
{

using Row3 = Eigen::RowVector3d;

}

double tangential_speed(const Surface& surface, const Points& velocity)
{
  const Row3 U = surface.mean_velocity(flat(velocity)).transpose();
  double speed = 0;
  for (int i = 0; i < velocity.rows(); ++i)
  {
    const Row3 relative = velocity.row(i) - U, n = surface.normals.row(i);
    speed = std::max(speed, (relative - relative.dot(n) * n).norm());
  }
  return speed;
}

double relaxation_rate(const Surface& surface, const Points& velocity, double scene_rate)
{
  return 0.2 * scene_rate + 3 * tangential_speed(surface, velocity);
}

Points equidistributing_velocity(const Surface& surface, const AdjacencyList& neighbours,
  const Points& velocity, double scene_rate)
{
  const Row3 U = surface.mean_velocity(flat(velocity)).transpose();
  const double kappa = relaxation_rate(surface, velocity, scene_rate);
  const Points& points = surface.vertices;
  Points w(points.rows(), 3);
  for (int i = 0; i < points.rows(); ++i)
  {
    const Row3 n = surface.normals.row(i);
    Row3 to_mean = Row3::Zero();
    double area = 0;
    for (const int* j = neighbours.begin(i); j != neighbours.end(i); ++j)
    {
      to_mean += surface.vertex_area[*j] * (points.row(*j) - points.row(i));
      area += surface.vertex_area[*j];
    }
    to_mean /= area;
    w.row(i) = U + (velocity.row(i) - U).dot(n) * n + kappa * (to_mean - to_mean.dot(n) * n);
  }
  return w;
}

}
