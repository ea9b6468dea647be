#include "solver/surface/SparseCholesky.h"

template class Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;
template class Eigen::SimplicialCholeskyBase<Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>>;
