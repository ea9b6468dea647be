#pragma once
// Eigen's sparse LU decomposition for double precision. Who includes it here takes it from the
// library, for right-hand sides of several columns (Eigen::MatrixXd), instead of compiling it again.

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

extern template class Eigen::SparseLU<Eigen::SparseMatrix<double>>;
extern template class Eigen::internal::SparseLUImpl<double, int>;
extern template void Eigen::internal::MappedSuperNodalMatrix<double, int>::solveInPlace(
  Eigen::MatrixBase<Eigen::MatrixXd>&) const;
