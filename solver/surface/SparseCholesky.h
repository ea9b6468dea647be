#pragma once
// Eigen's sparse Cholesky decompositions for double precision, compiled once in the library.

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

namespace vesicle
{

using SymmetricMatrix = Eigen::SparseMatrix<double>; ///< by columns
/// Of symmetric matrices whose leading blocks are all regular, indefinite or not.
using SparseCholesky = Eigen::SimplicialLDLT<SymmetricMatrix>;

}
