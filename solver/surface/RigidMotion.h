#pragma once
// The rigid motion that a moving surface's shape makes.

#include "solver/surface/Surface.h"

namespace vesicle
{

using Vector6 = Eigen::Matrix<double, 6, 1>;

/// ρ(u) = U + Ω × (x − x_c): U the velocity of the volume's centroid x_c, Ω the rotation that the
/// normal velocities are nearest to, min Σ m_i (n_i·(u_i − ρ_i))² + ε |Ω|². ε, 1e-3 Σ m_i r_i²,
/// leaves out turns that hardly move the surface: those of a sphere, or about an axis of revolution.
/// Linear in u; a membrane that runs around a shape at rest has none.
class RigidMotion
{
public:
  /// The surface must outlive it.
  explicit RigidMotion(const Surface& surface);

  /// (U, Ω) from the velocities of the vertices, 3N.
  Vector6 motion(const Eigen::VectorXd& at_vertices) const;
  /// Its transpose: a functional of the vertices' velocities, 3N.
  Eigen::VectorXd motion_adjoint(const Vector6& dual) const;

  /// The rigid velocities of points: N by 3.
  Points velocity(const Vector6& motion, const Points& points) const;
  /// Its transpose: force and torque about x_c of forces at the points, N by 3.
  Vector6 velocity_adjoint(const Points& forces, const Points& points) const;

private:
  const Surface& surface_;
  Eigen::Matrix<double, 3, Eigen::Dynamic> rotation_; ///< Ω of u − U, 3 by 3N
};

}
