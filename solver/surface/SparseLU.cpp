#include "solver/surface/SparseLU.h"

template class Eigen::SparseLU<Eigen::SparseMatrix<double>>;
template class Eigen::internal::SparseLUImpl<double, int>;
template void Eigen::internal::MappedSuperNodalMatrix<double, int>::solveInPlace(
  Eigen::MatrixBase<Eigen::MatrixXd>&) const;
