#include "solver/linear/DensePanel.h"

#include "solver/Multiversion.h"

#include <cblas.h>

#include <algorithm>
#include <cmath>
#include <concepts>

namespace vesicle
{

namespace
{

// Columns whose changes are applied to all others at once.
constexpr int panel_block = 32;
// Columns of an outer product at once: half of what lies above the diagonal is left out.
constexpr int product_block = 48;

// C −= A Bᵀ
template<class Scalar>
void subtract_product(int rows, int columns, int inner, const Scalar* A, int lda, const Scalar* B,
  int ldb, Scalar* C, int ldc)
{
  if constexpr (std::same_as<Scalar, double>)
    cblas_dgemm(
      CblasColMajor, CblasNoTrans, CblasTrans, rows, columns, inner, -1, A, lda, B, ldb, 1, C, ldc);
  else
    cblas_sgemm(
      CblasColMajor, CblasNoTrans, CblasTrans, rows, columns, inner, -1, A, lda, B, ldb, 1, C, ldc);
}

// X ← X L⁻ᵀ
template<class Scalar>
void divide_from_the_right(int rows, int columns, const Scalar* L, Scalar* X, int height)
{
  if constexpr (std::same_as<Scalar, double>)
    cblas_dtrsm(CblasColMajor, CblasRight, CblasLower, CblasTrans, CblasUnit, rows, columns, 1, L,
      height, X, height);
  else
    cblas_strsm(CblasColMajor, CblasRight, CblasLower, CblasTrans, CblasUnit, rows, columns, 1, L,
      height, X, height);
}

template<class Scalar>
bool factorize_block(Scalar* A, int n, int height, Scalar* pivots)
{
  for (int k = 0; k < n; ++k)
  {
    Scalar* column = A + static_cast<long>(k) * height;
    const Scalar pivot = column[k];
    if (pivot == 0 || !std::isfinite(pivot))
      return false;
    pivots[k] = pivot;
    for (int j = k + 1; j < n; ++j)
    {
      const Scalar l = column[j] / pivot;
      Scalar* target = A + static_cast<long>(j) * height;
      for (int i = j; i < n; ++i)
        target[i] -= column[i] * l;
    }
    for (int i = k + 1; i < n; ++i)
      column[i] /= pivot;
  }
  return true;
}

// From L D in `columns` columns of L: L D to `product`, L in its place.
template<class Scalar>
void divide_by_pivots(
  Scalar* L, int height, int rows, int columns, const Scalar* pivots, Scalar* product)
{
  for (int j = 0; j < columns; ++j)
    for (int i = 0; i < rows; ++i)
    {
      Scalar& entry = L[static_cast<long>(j) * height + i];
      product[static_cast<long>(j) * rows + i] = entry;
      entry /= pivots[j];
    }
}

}

template<class Scalar>
bool factorize_panel(
  Scalar* panel, int height, int columns, Scalar* pivots, std::vector<Scalar>& work)
{
  const auto at = [&](int i, int j) { return panel + static_cast<long>(j) * height + i; };
  for (int k = 0; k < columns; k += panel_block)
  {
    const int width = std::min(panel_block, columns - k), next = k + width, rows = height - next;
    if (!factorize_block(at(k, k), width, height, pivots + k))
      return false;
    if (rows == 0)
      continue;
    divide_from_the_right(rows, width, at(k, k), at(next, k), height);
    work.resize(static_cast<std::size_t>(rows) * width);
    divide_by_pivots(at(next, k), height, rows, width, pivots + k, work.data());
    if (next < columns)
      subtract_product(rows, columns - next, width, work.data(), rows, at(next, k), height,
        at(next, next), height);
  }
  return true;
}

template<class Scalar>
void subtract_outer_product(Scalar* U, int rows, const Scalar* L, int height, int columns,
  const Scalar* pivots, std::vector<Scalar>& work)
{
  work.resize(static_cast<std::size_t>(rows) * columns);
  for (int j = 0; j < columns; ++j)
    for (int i = 0; i < rows; ++i)
      work[static_cast<std::size_t>(j) * rows + i] =
        L[static_cast<long>(j) * height + i] * pivots[j];
  for (int j = 0; j < rows; j += product_block)
    subtract_product(rows - j, std::min(product_block, rows - j), columns, work.data() + j, rows,
      L + j, height, U + static_cast<long>(j) * rows + j, rows);
}

// The solves are a few thousand operations on panels that lie in the caches: OpenBLAS's calls would
// cost as much as the work.
namespace
{

template<class Scalar>
VESICLE_INLINE void subtract_multiple(const Scalar* a, Scalar factor, Scalar* from, int n)
{
#pragma omp simd
  for (int i = 0; i < n; ++i)
    from[i] -= factor * a[i];
}

template<class Scalar>
VESICLE_INLINE Scalar dot(const Scalar* a, const Scalar* b, int n)
{
  Scalar sum = 0;
#pragma omp simd reduction(+ : sum)
  for (int i = 0; i < n; ++i)
    sum += a[i] * b[i];
  return sum;
}

template<class Scalar>
VESICLE_INLINE void forward(const Scalar* panel, int height, int columns, Scalar* x, Scalar* below)
{
  for (int j = 0; j < columns; ++j, panel += height)
  {
    subtract_multiple(panel + j + 1, x[j], x + j + 1, columns - j - 1);
    subtract_multiple(panel + columns, x[j], below, height - columns);
  }
}

template<class Scalar>
VESICLE_INLINE void backward(
  const Scalar* panel, int height, int columns, Scalar* x, const Scalar* below)
{
  for (int j = columns - 1; j >= 0; --j)
  {
    const Scalar* column = panel + static_cast<long>(j) * height;
    x[j] -= dot(column + columns, below, height - columns) +
      dot(column + j + 1, x + j + 1, columns - j - 1);
  }
}

}

VESICLE_MULTIVERSION
void solve_forward(const double* panel, int height, int columns, double* x, double* below)
{
  forward(panel, height, columns, x, below);
}

VESICLE_MULTIVERSION
void solve_forward(const float* panel, int height, int columns, float* x, float* below)
{
  forward(panel, height, columns, x, below);
}

VESICLE_MULTIVERSION
void solve_backward(const double* panel, int height, int columns, double* x, const double* below)
{
  backward(panel, height, columns, x, below);
}

VESICLE_MULTIVERSION
void solve_backward(const float* panel, int height, int columns, float* x, const float* below)
{
  backward(panel, height, columns, x, below);
}

template bool factorize_panel(double*, int, int, double*, std::vector<double>&);
template bool factorize_panel(float*, int, int, float*, std::vector<float>&);
template void subtract_outer_product(
  double*, int, const double*, int, int, const double*, std::vector<double>&);
template void subtract_outer_product(
  float*, int, const float*, int, int, const float*, std::vector<float>&);

}
