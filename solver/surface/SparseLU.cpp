#include "solver/surface/SparseLU.h"

template class Eigen::SparseLU<Eigen::SparseMatrix<double>>;
template class Eigen::internal::SparseLUImpl<double, int>;
