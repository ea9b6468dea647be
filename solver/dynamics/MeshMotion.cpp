#include "solver/dynamics/MeshMotion.h"

#include "solver/dynamics/TangentialMotion.h"

#include <algorithm>
#include <cmath>

namespace vesicle
{

namespace
{

using Row3 = Eigen::RowVector3d;

// U + n n·(u − U).
Points normal_motion(const Surface& surface, const Points& velocity)
{
  const Row3 U = surface.mean_velocity(flat(velocity)).transpose();
  const Eigen::VectorXd speed =
    surface.normals.cwiseProduct(velocity.rowwise() - U).rowwise().sum();
  return rows_of_three(scaled_rows(surface.normals, speed)).rowwise() + U;
}

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

namespace
{

// κ P_t (area-weighted mean of the neighbours − x).
Points relaxation(const Surface& surface, const AdjacencyList& neighbours, const Points& velocity,
  double scene_rate)
{
  const double kappa = relaxation_rate(surface, velocity, scene_rate);
  const Points& points = surface.vertices;
  Points t(points.rows(), 3);
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
    t.row(i) = kappa * (to_mean - to_mean.dot(n) * n);
  }
  return t;
}

}

Points equidistributing_velocity(const Surface& surface, const AdjacencyList& neighbours,
  const Points& velocity, double scene_rate)
{
  return normal_motion(surface, velocity) + relaxation(surface, neighbours, velocity, scene_rate);
}

Points sliding_velocity(const VesicleLoads& loads, const AdjacencyList& neighbours,
  const Points& velocity, double scene_rate, double tau, const Points& reference)
{
  // The mobility of a force on an edge's length of membrane, in edges: 1/(4k) at the shortest wave
  // k = π/h is h/13; a multiple moves the mesh as far as the steps allow.
  constexpr double mobility_in_edges = 0.125;
  const Surface& surface = loads.surface();
  const NodeMotion normal(surface, NodeMotionKind::normal);
  const double released = -loads.gradient().dot(normal.velocity(normal.parameters(flat(velocity)))),
               edge = std::sqrt(surface.area / static_cast<double>(surface.vertices.rows()));
  const Row3 U = surface.mean_velocity(flat(velocity)).transpose();
  const Points relative = reference.rows() > 0 ? Points(reference.rowwise() - U) : Points(0, 3);
  const Points wanted = relaxation(surface, neighbours, velocity, scene_rate);
  return normal_motion(surface, velocity) +
    rows_of_three(tangential_motion(
      loads, flat(wanted), flat(relative), released, tau, mobility_in_edges * edge));
}

}
