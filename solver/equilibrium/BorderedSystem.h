#pragma once
// Newton's step under constraints: a sparse symmetric matrix with a few full rows and columns.

#include "solver/linear/SparseCholesky.h"

namespace vesicle
{

/// [K B; Bᵀ −D] [x; y] = [b; c], K by its lower triangle, B of few columns. D is 0 for a constraint;
/// a part u uᵀ/d of the matrix that K leaves out is a column u with d.
class BorderedSystem
{
public:
  /// The pattern of K is analysed once.
  void compute(const SymmetricMatrix& K, const Eigen::MatrixXd& B, const Eigen::VectorXd& D);
  /// The number of negative eigenvalues of the matrix with its added part on the null space of the
  /// constraints (by Sylvester's law, from the signs of the pivots): 0 where the step is one towards
  /// a minimum.
  int index() const { return index_; }
  struct Solution
  {
    Eigen::VectorXd x, y;
  };
  Solution solve(const Eigen::VectorXd& b, const Eigen::VectorXd& c) const;

private:
  SparseCholesky factors_;
  Eigen::MatrixXd border_, solved_border_, schur_;
  int index_ = 0;
};

}
