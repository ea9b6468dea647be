#include "solver/linear/GroupedRows.h"

#include "solver/Lanes.h"
#include "solver/ParallelFor.h"

#include <vector>

namespace vesicle
{

namespace
{

// y = A x of `rows` rows with `count` numbers each.
template<int rows>
VESICLE_INLINE void multiply_dense(int count, const double* value, const double* x, double* y)
{
  constexpr int chains = 2; // sums that don't wait for each other
  Lanes sum[rows][chains]{};
  int k = 0;
  for (; k + chains * lanes <= count; k += chains * lanes)
    for (int r = 0; r < rows; ++r)
      for (int c = 0; c < chains; ++c)
        sum[r][c] += lanes_at(value + r * count + k + c * lanes) * lanes_at(x + k + c * lanes);
  for (int r = 0; r < rows; ++r)
  {
    y[r] = sum_of(sum[r][0] + sum[r][1]);
    for (int rest = k; rest < count; ++rest)
      y[r] += value[r * count + rest] * x[rest];
  }
}

// Of `count` columns: what they have of x is looked up once for all rows.
VESICLE_MULTIVERSION
void multiply_group(int together, int count, const int* column, const double* value,
  const double* x, double* looked_up, double* y)
{
  for (int k = 0; k < count; ++k)
    looked_up[k] = x[column[k]];
  if (together == 3)
    multiply_dense<3>(count, value, looked_up, y);
  else
    for (int r = 0; r < together; ++r)
      multiply_dense<1>(count, value + r * count, looked_up, y + r);
}

}

Eigen::VectorXd multiply_grouped(
  const Eigen::SparseMatrix<double, Eigen::RowMajor>& A, int together, const Eigen::VectorXd& x)
{
  constexpr Eigen::Index grain = 128; // groups of some hundred numbers each
  Eigen::VectorXd y(A.rows());
  const int* outer = A.outerIndexPtr();
  parallel_for(
    A.rows() / together,
    [&](Eigen::Index group)
    {
      const Eigen::Index row = group * together;
      const int begin = outer[row], count = outer[row + 1] - begin;
      thread_local std::vector<double> looked_up;
      looked_up.resize(count);
      multiply_group(together, count, A.innerIndexPtr() + begin, A.valuePtr() + begin, x.data(),
        looked_up.data(), y.data() + row);
    },
    grain);
  return y;
}

}
