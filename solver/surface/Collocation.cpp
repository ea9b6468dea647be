#include "solver/surface/Collocation.h"

#include "solver/ParallelFor.h"
#include "solver/surface/SparseLU.h"

namespace vesicle
{

namespace
{

using ColumnMatrix = Eigen::SparseMatrix<double>;
using SparseFactors = Eigen::SparseLU<ColumnMatrix>;

// Bounds of the eigenvalues of P: 1/4 to 1 for valence six, a little lower for small valences.
constexpr double smallest_eigenvalue = 0.2, largest_eigenvalue = 1;
constexpr int chebyshev_sweeps = 6;

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

// Chebyshev iteration: each sweep is a product with P, and six leave an error of 0.2%.
void Collocation::to_control_roughly(Eigen::Ref<RowsF> velocities) const
{
  if (!factors_)
    return;
  const double centre = (largest_eigenvalue + smallest_eigenvalue) / 2,
               radius = (largest_eigenvalue - smallest_eigenvalue) / 2, sigma = centre / radius;
  RowsF direction = velocities / static_cast<float>(centre);
  RowsF x = direction;
  double rho = 1 / sigma;
  for (int sweep = 0; sweep < chebyshev_sweeps; ++sweep)
  {
    const double next = 1 / (2 * sigma - rho);
    RowsF residual = velocities;
    parallel_for(static_cast<int>(P_.rows()),
      [&](int i)
      {
        for (SparseMatrix::InnerIterator it(P_, i); it; ++it)
          residual.middleRows<3>(3 * i) -=
            static_cast<float>(it.value()) * x.middleRows<3>(3 * it.col());
      });
    direction =
      static_cast<float>(next * rho) * direction + static_cast<float>(2 * next / radius) * residual;
    x += direction;
    rho = next;
  }
  velocities = x;
}

}
