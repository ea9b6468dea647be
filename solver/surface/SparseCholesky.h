#pragma once
// Eigen's sparse Cholesky decomposition LDLᵀ for double precision. Who includes it here takes it from
// the library, instead of compiling it again.

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

namespace vesicle
{

using SymmetricMatrix = Eigen::SparseMatrix<double>; ///< by columns
/// Of symmetric matrices whose leading blocks are all regular, indefinite or not.
using SparseCholesky = Eigen::SimplicialLDLT<SymmetricMatrix>;

}

extern template class Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;
extern template class Eigen::SimplicialCholeskyBase<
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>>;
