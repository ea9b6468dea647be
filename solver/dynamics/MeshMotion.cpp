#include "solver/dynamics/MeshMotion.h"

#include "solver/mesh/SizingLaw.h"

#include <algorithm>
#include <cmath>

namespace vesicle
{

namespace
{

using Row3 = Eigen::RowVector3d;

// ρ + n ν at the vertices: the normal motion of the nodes.
Points normal_motion(const Surface& surface, const NodeMotion& motion, const Points& velocity,
  const Eigen::VectorXd& parameters)
{
  return motion.rigid(flat(velocity)) + rows_of_three(scaled_rows(surface.normals, parameters));
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

// κ P_t (towards the wanted edge lengths). The mean of centroids is two thirds of the way to that of
// the neighbours.
Points relaxation(const Surface& surface, const AdjacencyList& neighbours, const Points& velocity,
  double scene_rate)
{
  const double kappa = relaxation_rate(surface, velocity, scene_rate);
  const Triangles& triangles = surface.space->triangles();
  const Eigen::VectorXd wanted = wanted_edge_lengths({}, surface.vertices, neighbours,
    squared_curvature(surface), surface.vertex_area, static_cast<int>(triangles.rows()));
  const Points t = 1.5 * kappa * towards_wanted(surface.vertices, triangles, wanted);
  return t -
    rows_of_three(scaled_rows(surface.normals, t.cwiseProduct(surface.normals).rowwise().sum()));
}

}

Points equidistributing_velocity(const Surface& surface, const AdjacencyList& neighbours,
  const Points& velocity, double scene_rate)
{
  const NodeMotion motion(surface, NodeMotionKind::normal);
  return normal_motion(surface, motion, velocity, motion.parameters(flat(velocity))) +
    relaxation(surface, neighbours, velocity, scene_rate);
}

TangentialMotion sliding_motion(const VesicleLoads& loads, double tau)
{
  // The mobility of a force on an edge's length of membrane, in edges: 1/(4k) at the shortest wave
  // k = π/h is h/13; a multiple moves the mesh as far as the steps allow.
  constexpr double mobility_in_edges = 0.125;
  const Surface& surface = loads.surface();
  const double edge = std::sqrt(surface.area / static_cast<double>(surface.vertices.rows()));
  return { loads, tau, mobility_in_edges * edge };
}

Points sliding_velocity(const VesicleLoads& loads, const TangentialMotion& sliding,
  const AdjacencyList& neighbours, const Points& velocity, double scene_rate,
  const Points& reference)
{
  const Surface& surface = loads.surface();
  const NodeMotion& motion = loads.motion();
  const Eigen::VectorXd parameters = motion.parameters(flat(velocity));
  const double released = -loads.gradient().dot(motion.velocity(parameters));
  const Points along_normals = normal_motion(surface, motion, velocity, parameters);
  // The normal motion counts once: as often as the mesh's own it would have the mesh run ahead of a
  // change of shape that hasn't come.
  Points otherwise = along_normals;
  if (reference.rows() > 0)
  {
    const Points before =
      normal_motion(surface, motion, reference, motion.parameters(flat(reference)));
    otherwise -= before + mesh_implicitness * (reference - before);
  }
  const Points wanted = relaxation(surface, neighbours, velocity, scene_rate);
  return along_normals + rows_of_three(sliding.velocities(flat(wanted), flat(otherwise), released));
}

}
