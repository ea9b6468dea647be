#include "solver/dynamics/MeshMotion.h"

#include <algorithm>

namespace vesicle
{

namespace
{

using Row3 = Eigen::RowVector3d;

Row3 mean_velocity(const ShapeOperators& shape, const Points& velocity)
{
  return (shape.centroid_velocity * flat(velocity)).transpose();
}

}

double tangential_speed(const ShapeOperators& shape, const Points& velocity)
{
  const Row3 U = mean_velocity(shape, velocity);
  double speed = 0;
  for (int i = 0; i < velocity.rows(); ++i)
  {
    const Row3 relative = velocity.row(i) - U, n = shape.outward.row(i);
    speed = std::max(speed, (relative - relative.dot(n) * n).norm());
  }
  return speed;
}

double relaxation_rate(const ShapeOperators& shape, const Points& velocity, double scene_rate)
{
  return 0.2 * scene_rate + 3 * tangential_speed(shape, velocity);
}

Points equidistributing_velocity(const ShapeOperators& shape, const AdjacencyList& neighbours,
  const Points& points, const Points& velocity, double scene_rate)
{
  const Row3 U = mean_velocity(shape, velocity);
  const double kappa = relaxation_rate(shape, velocity, scene_rate);
  Points w(points.rows(), 3);
  for (int i = 0; i < points.rows(); ++i)
  {
    const Row3 n = shape.outward.row(i);
    Row3 to_mean = Row3::Zero();
    double area = 0;
    for (const int* j = neighbours.begin(i); j != neighbours.end(i); ++j)
    {
      to_mean += shape.vertex_area[*j] * (points.row(*j) - points.row(i));
      area += shape.vertex_area[*j];
    }
    to_mean /= area;
    w.row(i) = U + (velocity.row(i) - U).dot(n) * n + kappa * (to_mean - to_mean.dot(n) * n);
  }
  return w;
}

}
