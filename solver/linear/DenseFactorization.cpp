#include "solver/linear/DenseFactorization.h"

#include "solver/Errors.h"
#include "solver/ParallelFor.h"
#include "solver/linear/Blas.h"

#include <cblas.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

extern "C" void sgetrf_(
  const int* m, const int* n, float* a, const int* lda, int* pivot, int* info);

namespace vesicle
{

namespace
{

// Columns a panel: wide enough that the update, a matrix product, takes nearly all of the time.
constexpr int panel_width = 96;
// Columns a task of the update. Fixed, so that rounding doesn't depend on the number of threads.
constexpr int task_width = 192;

void exchange_rows(float* column, const std::vector<int>& pivot, int begin, int end)
{
  for (int i = begin; i < end; ++i)
    std::swap(column[i], column[pivot[i]]);
}

}

void DenseFactorization::compute(Matrix matrix)
{
  use_one_blas_thread();
  lu_ = std::move(matrix);
  const int n = static_cast<int>(lu_.rows());
  row_scale_ = lu_.cwiseAbs().rowwise().maxCoeff();
  for (int i = 0; i < n; ++i)
  {
    if (!(row_scale_[i] > 0) || !std::isfinite(row_scale_[i]))
      throw NumericalError(fmt::format("linear system: row {} of {} is zero or not finite", i, n));
    row_scale_[i] = 1 / row_scale_[i];
  }
  parallel_for(n, [&](int j) { lu_.col(j).array() *= row_scale_.array(); });

  pivot_.assign(n, 0);
  float* a = lu_.data();
  const auto at = [&](int i, int j) { return a + static_cast<long>(j) * n + i; };
  for (int k = 0; k < n; k += panel_width)
  {
    const int width = std::min(panel_width, n - k), rows = n - k, next = k + width;
    int info = 0;
    sgetrf_(&rows, &width, at(k, k), &n, pivot_.data() + k, &info);
    if (info != 0)
      throw NumericalError(
        fmt::format("linear system of {} unknowns is singular at pivot {}", n, k + info - 1));
    for (int i = k; i < next; ++i)
      pivot_[i] += k - 1; // LAPACK counts from 1, from the panel's first row
    const auto update = [&](int begin, int end)
    {
      for (int j = begin; j < end; ++j)
        exchange_rows(at(0, j), pivot_, k, next);
      cblas_strsm(CblasColMajor, CblasLeft, CblasLower, CblasNoTrans, CblasUnit, width, end - begin,
        1, at(k, k), n, at(k, begin), n);
      if (next < n)
        cblas_sgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, n - next, end - begin, width, -1,
          at(next, k), n, at(k, begin), n, 1, at(next, begin), n);
    };
    for (int j = 0; j < k; ++j)
      exchange_rows(at(0, j), pivot_, k, next);
    const int tasks = (n - next + task_width - 1) / task_width;
    parallel_for(tasks,
      [&](int task)
      {
        const int begin = next + task * task_width;
        update(begin, std::min(begin + task_width, n));
      });
  }
}

Eigen::VectorXd DenseFactorization::solve(const Eigen::VectorXd& right_side) const
{
  // The scale of the right-hand side is taken out: single precision has a narrow range.
  const double scale = right_side.cwiseAbs().maxCoeff();
  if (!(scale > 0))
    return Eigen::VectorXd::Zero(right_side.size());
  Eigen::VectorXf x = ((right_side / scale).cast<float>().array() * row_scale_.array()).matrix();
  const int n = static_cast<int>(x.size());
  exchange_rows(x.data(), pivot_, 0, n);
  cblas_strsv(CblasColMajor, CblasLower, CblasNoTrans, CblasUnit, n, lu_.data(), n, x.data(), 1);
  cblas_strsv(CblasColMajor, CblasUpper, CblasNoTrans, CblasNonUnit, n, lu_.data(), n, x.data(), 1);
  return scale * x.cast<double>();
}

}
