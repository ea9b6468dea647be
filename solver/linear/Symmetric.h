#pragma once

#include "solver/linear/EliminationPlan.h"

namespace vesicle
{

/// A symmetric matrix by columns, which it is by rows already: nothing is sorted.
inline SymmetricMatrix by_columns(const Eigen::SparseMatrix<double, Eigen::RowMajor>& symmetric)
{
  return Eigen::Map<const SymmetricMatrix>(symmetric.rows(), symmetric.cols(), symmetric.nonZeros(),
    symmetric.outerIndexPtr(), symmetric.innerIndexPtr(), symmetric.valuePtr());
}

}
