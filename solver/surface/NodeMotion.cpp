#include "solver/surface/NodeMotion.h"

namespace vesicle
{

NodeMotion::NodeMotion(const Surface& surface, NodeMotionKind kind)
  : surface_(surface), rigid_(surface), kind_(kind)
{
}

Points NodeMotion::rigid(const Eigen::VectorXd& at_vertices) const
{
  return rigid_.velocity(rigid_.motion(at_vertices), surface_.vertices);
}

Eigen::VectorXd NodeMotion::parameters(const Eigen::VectorXd& at_vertices) const
{
  const Points relative = rows_of_three(at_vertices) - rigid(at_vertices);
  if (kind_ == NodeMotionKind::normal)
    return surface_.normals.cwiseProduct(relative).rowwise().sum();
  return surface_.to_control(flat(relative));
}

// The functional ν ↦ dual·ν of u.
Eigen::VectorXd NodeMotion::parameters_adjoint(const Eigen::VectorXd& dual) const
{
  const Eigen::VectorXd at_vertices = kind_ == NodeMotionKind::normal
    ? scaled_rows(surface_.normals, dual)
    : surface_.collocation().from_control(dual);
  return surface_.collocation().to_vertices_adjoint(at_vertices -
    rigid_.motion_adjoint(rigid_.velocity_adjoint(rows_of_three(at_vertices), surface_.vertices)));
}

Eigen::VectorXd NodeMotion::velocity(const Eigen::VectorXd& parameters) const
{
  return kind_ == NodeMotionKind::normal
    ? surface_.to_control(scaled_rows(surface_.normals, parameters))
    : parameters;
}

Eigen::VectorXd NodeMotion::velocity_adjoint(const Eigen::VectorXd& functional) const
{
  if (kind_ == NodeMotionKind::material)
    return functional;
  return surface_.normals
    .cwiseProduct(rows_of_three(surface_.collocation().from_control(functional)))
    .rowwise()
    .sum();
}

Eigen::VectorXd NodeMotion::adjoint(const Eigen::VectorXd& functional) const
{
  return parameters_adjoint(velocity_adjoint(functional)) +
    surface_.collocation().to_vertices_adjoint(
      rigid_.motion_adjoint(rigid_.velocity_adjoint(rows_of_three(functional), surface_.control)));
}

}
