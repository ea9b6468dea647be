#include "solver/surface/NodeMotion.h"

namespace vesicle
{

namespace
{

Vector3 sum_of_rows(const Eigen::VectorXd& vectors)
{
  return rows_of_three(vectors).colwise().sum().transpose();
}

}

Eigen::VectorXd NodeMotion::parameters(const Eigen::VectorXd& at_vertices) const
{
  const Eigen::VectorXd relative = surface_.relative_to_centroid(at_vertices);
  if (kind_ == NodeMotionKind::normal)
    return surface_.normals.cwiseProduct(rows_of_three(relative)).rowwise().sum();
  return surface_.to_control(relative);
}

// The functional ν ↦ dual·ν of u: Pᵀ(1 − Wᵀ1ᵀ)(…), where 1ᵀP = 1ᵀ and W P is the centroid's.
Eigen::VectorXd NodeMotion::parameters_adjoint(const Eigen::VectorXd& dual) const
{
  const Eigen::VectorXd at_vertices = kind_ == NodeMotionKind::normal
    ? scaled_rows(surface_.normals, dual)
    : surface_.collocation().from_control(dual);
  return surface_.collocation().to_vertices_adjoint(
    at_vertices - surface_.centroid_velocity.transpose() * sum_of_rows(at_vertices));
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
      surface_.centroid_velocity.transpose() * sum_of_rows(functional));
}

}
