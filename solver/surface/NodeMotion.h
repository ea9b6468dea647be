#pragma once
// How a surface's nodes follow the fluid, as a linear map Q on the velocities of the control points,
// and its adjoint, which makes loads of gradients: whatever moves the nodes by Q u does the work
// g·Q u = Qᵀg·u on an energy of gradient g. Only Q's normal part is physics; along the membrane a
// fluid leaves the nodes free.

#include "solver/surface/NodeMotionKind.h"
#include "solver/surface/RigidMotion.h"

namespace vesicle
{

/// Q factors through ν, numbers that a rigid motion leaves zero: Q u = D ν + P⁻¹ρ, ν = E u. Normal:
/// ν = n·(P u − ρ) at the vertices, N; material: ν = u − ρ, 3N. Velocities are the control points', 3N. An energy that no rigid motion changes has
/// loads without a net force, and but for ρ's ε without a torque: a mesh that stood still while its
/// vesicle turns would hold it where the coarse energy is least.
class NodeMotion
{
public:
  /// The surface must outlive it.
  NodeMotion(const Surface& surface, NodeMotionKind kind);

  NodeMotionKind kind() const { return kind_; }
  Eigen::Index size() const
  {
    return surface_.normals.rows() * (kind_ == NodeMotionKind::normal ? 1 : 3);
  }
  /// E, from the velocities of the vertices, P u.
  Eigen::VectorXd parameters(const Eigen::VectorXd& at_vertices) const;
  /// Eᵀ P⁻ᵀ … of numbers that belong to ν: a functional of the control points' velocities.
  Eigen::VectorXd parameters_adjoint(const Eigen::VectorXd& dual) const;
  /// D: control points' velocities.
  Eigen::VectorXd velocity(const Eigen::VectorXd& parameters) const;
  /// Dᵀ.
  Eigen::VectorXd velocity_adjoint(const Eigen::VectorXd& functional) const;

  /// ρ at the vertices, N by 3.
  Points rigid(const Eigen::VectorXd& at_vertices) const;
  /// Qᵀ.
  Eigen::VectorXd adjoint(const Eigen::VectorXd& functional) const;

private:
  const Surface& surface_;
  RigidMotion rigid_;
  NodeMotionKind kind_;
};

}
