#pragma once
// Products with sparse matrices whose rows come in groups that have the same columns, as those of a
// node's three directions do.

#include <Eigen/SparseCore>

namespace vesicle
{

/// A x; each `together` rows of A have the same columns. Threads share the groups.
Eigen::VectorXd multiply_grouped(
  const Eigen::SparseMatrix<double, Eigen::RowMajor>& A, int together, const Eigen::VectorXd& x);

}
