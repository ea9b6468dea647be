#include "solver/surface/Collocation.h"

#include "solver/surface/SparseLU.h"

namespace vesicle
{

namespace
{

using ColumnMatrix = Eigen::SparseMatrix<double>;
using SparseFactors = Eigen::SparseLU<ColumnMatrix>;

void factorize(SparseFactors& factors, ColumnMatrix matrix)
{
  matrix.makeCompressed();
  factors.compute(matrix);
}

Eigen::VectorXd solve(const SparseFactors& factors, const Eigen::VectorXd& vector)
{
  const Eigen::MatrixXd columns = rows_of_three(vector);
  const Points result = Eigen::MatrixXd(factors.solve(columns));
  return flat(result);
}

}

struct Collocation::Factors
{
  SparseFactors fit, fit_transposed;
};

Collocation::Collocation(const Basis& basis) : P_(basis.collocation())
{
  if (!basis.smooth())
    return;
  auto factors = std::make_unique<Factors>();
  factorize(factors->fit, P_);
  factorize(factors->fit_transposed, P_.transpose());
  factors_ = std::move(factors);
}

Collocation::~Collocation() = default;
Collocation::Collocation(Collocation&&) noexcept = default;

Eigen::VectorXd Collocation::at_vertices(const Eigen::VectorXd& nodal) const
{
  return factors_ ? Eigen::VectorXd(P_ * nodal) : nodal;
}

Eigen::MatrixXd Collocation::fit(const Eigen::MatrixXd& at_vertices) const
{
  return factors_ ? Eigen::MatrixXd(factors_->fit.solve(at_vertices)) : at_vertices;
}

Eigen::MatrixXd Collocation::fit_adjoint(const Eigen::MatrixXd& of_control) const
{
  return factors_ ? Eigen::MatrixXd(factors_->fit_transposed.solve(of_control)) : of_control;
}

Eigen::VectorXd Collocation::to_control(const Eigen::VectorXd& at_vertices) const
{
  return factors_ ? solve(factors_->fit, at_vertices) : at_vertices;
}

Eigen::VectorXd Collocation::to_vertices(const Eigen::VectorXd& control) const
{
  return factors_ ? Eigen::VectorXd(flat(Points(P_ * rows_of_three(control)))) : control;
}

Eigen::VectorXd Collocation::to_vertices_adjoint(const Eigen::VectorXd& functional) const
{
  return factors_ ? Eigen::VectorXd(flat(Points(P_.transpose() * rows_of_three(functional))))
                  : functional;
}

Eigen::VectorXd Collocation::from_control(const Eigen::VectorXd& gradient) const
{
  return factors_ ? solve(factors_->fit_transposed, gradient) : gradient;
}

}
