#include "solver/surface/Collocation.h"

#include "solver/Errors.h"

namespace vesicle
{

namespace
{

Eigen::VectorXd by_component(const Eigen::VectorXd& vector, const auto& solve)
{
  const Eigen::MatrixXd columns = rows_of_three(vector);
  const Points result = solve(columns);
  return flat(result);
}

}

Collocation::Collocation(const Basis& basis) : P_(basis.collocation()), smooth_(basis.smooth())
{
  if (!smooth_)
    return;
  unscale_ = basis.collocation_scale().cwiseInverse();
  symmetric_.compute(SymmetricMatrix(unscale_.asDiagonal() * P_));
  if (!symmetric_.regular())
    throw InputError("the mesh has no Loop surface through its points");
}

Eigen::VectorXd Collocation::at_vertices(const Eigen::VectorXd& nodal) const
{
  return smooth_ ? Eigen::VectorXd(P_ * nodal) : nodal;
}

Eigen::MatrixXd Collocation::fit(const Eigen::MatrixXd& at_vertices) const
{
  return smooth_ ? symmetric_.solve(unscale_.asDiagonal() * at_vertices) : at_vertices;
}

Eigen::MatrixXd Collocation::fit_adjoint(const Eigen::MatrixXd& of_control) const
{
  return smooth_ ? Eigen::MatrixXd(unscale_.asDiagonal() * symmetric_.solve(of_control))
                 : of_control;
}

Eigen::VectorXd Collocation::to_control(const Eigen::VectorXd& at_vertices) const
{
  return smooth_
    ? by_component(at_vertices, [&](const Eigen::MatrixXd& columns) { return fit(columns); })
    : at_vertices;
}

Eigen::VectorXd Collocation::to_vertices(const Eigen::VectorXd& control) const
{
  return smooth_ ? Eigen::VectorXd(flat(Points(P_ * rows_of_three(control)))) : control;
}

Eigen::VectorXd Collocation::to_vertices_adjoint(const Eigen::VectorXd& functional) const
{
  return smooth_ ? Eigen::VectorXd(flat(Points(P_.transpose() * rows_of_three(functional))))
                 : functional;
}

Eigen::VectorXd Collocation::from_control(const Eigen::VectorXd& gradient) const
{
  return smooth_
    ? by_component(gradient, [&](const Eigen::MatrixXd& columns) { return fit_adjoint(columns); })
    : gradient;
}

}
