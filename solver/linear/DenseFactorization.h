#pragma once
// LU of a dense matrix in single precision: the preconditioner of the linear solves. Refined by an
// outer iteration in double precision, single precision halves time and memory and costs two or
// three sweeps.

#include <Eigen/Core>

#include <vector>

namespace vesicle
{

class DenseFactorization
{
public:
  using Matrix = Eigen::MatrixXf;

  /// Factorises in place with row scaling and partial pivoting, threads sharing the columns; the
  /// result does not depend on their number. Throws NumericalError if the matrix is singular.
  void compute(Matrix matrix);
  int size() const { return static_cast<int>(lu_.rows()); }
  /// One over the largest entry of each row: rows times this are of one size.
  Eigen::VectorXd row_scale() const { return row_scale_.cast<double>(); }
  Eigen::VectorXd solve(const Eigen::VectorXd& right_side) const;

private:
  Matrix lu_;
  Eigen::VectorXf row_scale_;
  std::vector<int> pivot_; ///< row exchanged with row i, from 0
};

}
