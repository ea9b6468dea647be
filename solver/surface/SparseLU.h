#pragma once
// Eigen's sparse LU decomposition for double precision. Who includes it here takes the part that
// doesn't depend on the right-hand side from the library instead of compiling it again.

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

extern template class Eigen::SparseLU<Eigen::SparseMatrix<double>>;
extern template class Eigen::internal::SparseLUImpl<double, int>;
