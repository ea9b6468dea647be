#include "solver/linear/DensePanel.h"

#include "solver/Lanes.h"

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

// Below the triangle four columns at once, so that what the rows there have is read once for all.

template<class Scalar>
VESICLE_INLINE void subtract_four(
  const Scalar* a, int height, const Scalar* factor, Scalar* from, int n)
{
  const Scalar *b = a + height, *c = b + height, *d = c + height;
  const Scalar of_a = factor[0], of_b = factor[1], of_c = factor[2], of_d = factor[3];
#pragma omp simd
  for (int i = 0; i < n; ++i)
    from[i] -= (of_a * a[i] + of_b * b[i]) + (of_c * c[i] + of_d * d[i]);
}

template<class Scalar>
VESICLE_INLINE void subtract_four_dots(
  const Scalar* a, int height, const Scalar* with, int n, Scalar* from)
{
  const Scalar *b = a + height, *c = b + height, *d = c + height;
  Scalar in_a = 0, in_b = 0, in_c = 0, in_d = 0;
#pragma omp simd reduction(+ : in_a, in_b, in_c, in_d)
  for (int i = 0; i < n; ++i)
  {
    in_a += a[i] * with[i];
    in_b += b[i] * with[i];
    in_c += c[i] * with[i];
    in_d += d[i] * with[i];
  }
  from[0] -= in_a;
  from[1] -= in_b;
  from[2] -= in_c;
  from[3] -= in_d;
}

template<class Scalar>
VESICLE_INLINE void forward(const Scalar* panel, int height, int columns, Scalar* x, Scalar* below)
{
  const auto column = [=](int j) { return panel + static_cast<long>(j) * height; };
  const int rows = height - columns;
  for (int j = 0; j < columns; ++j)
    subtract_multiple(column(j) + j + 1, x[j], x + j + 1, columns - j - 1);
  int j = 0;
  for (; j + 4 <= columns; j += 4)
    subtract_four(column(j) + columns, height, x + j, below, rows);
  for (; j < columns; ++j)
    subtract_multiple(column(j) + columns, x[j], below, rows);
}

template<class Scalar>
VESICLE_INLINE void backward(
  const Scalar* panel, int height, int columns, Scalar* x, const Scalar* below)
{
  const auto column = [=](int j) { return panel + static_cast<long>(j) * height; };
  const int rows = height - columns;
  int j = 0;
  for (; j + 4 <= columns; j += 4)
    subtract_four_dots(column(j) + columns, height, below, rows, x + j);
  for (; j < columns; ++j)
    x[j] -= dot(column(j) + columns, below, rows);
  for (j = columns - 1; j >= 0; --j)
    x[j] -= dot(column(j) + j + 1, x + j + 1, columns - j - 1);
}

// As many right sides as there are lanes.

template<class Scalar>
VESICLE_INLINE void forward_together(
  const Scalar* panel, int height, int columns, const int* rows, Scalar* x, Scalar* all)
{
  for (int j = 0; j < columns; ++j)
    for (int i = j + 1; i < columns; ++i)
      lanes_at(x + i * lanes) -= panel[static_cast<long>(j) * height + i] * lanes_at(x + j * lanes);
  for (int i = columns; i < height; ++i)
  {
    Scalar* to = all + static_cast<long>(rows[i - columns]) * lanes;
    typename LanesOf<Scalar>::type sum = lanes_at(to);
    for (int j = 0; j < columns; ++j)
      sum -= panel[static_cast<long>(j) * height + i] * lanes_at(x + j * lanes);
    lanes_at(to) = sum;
  }
}

// x_j less what the rows below have, of `width` columns from j on.
template<int width, class Scalar>
VESICLE_INLINE void subtract_below(
  const Scalar* column, int height, int below, const int* rows, Scalar* x, const Scalar* all)
{
  typename LanesOf<Scalar>::type sum[width]{};
  for (int i = 0; i < below; ++i)
  {
    const auto& at = lanes_at(all + static_cast<long>(rows[i]) * lanes);
    for (int w = 0; w < width; ++w)
      sum[w] += column[static_cast<long>(w) * height + i] * at;
  }
  for (int w = 0; w < width; ++w)
    lanes_at(x + w * lanes) -= sum[w];
}

template<class Scalar>
VESICLE_INLINE void backward_together(
  const Scalar* panel, int height, int columns, const int* rows, Scalar* x, const Scalar* all)
{
  constexpr int width = 4;
  const int below = height - columns;
  const Scalar* const first = panel + columns;
  int j = 0;
  for (; j + width <= columns; j += width)
    subtract_below<width>(
      first + static_cast<long>(j) * height, height, below, rows, x + j * lanes, all);
  for (; j < columns; ++j)
    subtract_below<1>(
      first + static_cast<long>(j) * height, height, below, rows, x + j * lanes, all);
  for (j = columns - 1; j >= 0; --j)
    for (int i = j + 1; i < columns; ++i)
      lanes_at(x + j * lanes) -= panel[static_cast<long>(j) * height + i] * lanes_at(x + i * lanes);
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

VESICLE_MULTIVERSION
void solve_forward_together(
  const double* panel, int height, int columns, const int* rows, double* x, double* all)
{
  forward_together(panel, height, columns, rows, x, all);
}

VESICLE_MULTIVERSION
void solve_forward_together(
  const float* panel, int height, int columns, const int* rows, float* x, float* all)
{
  forward_together(panel, height, columns, rows, x, all);
}

VESICLE_MULTIVERSION
void solve_backward_together(
  const double* panel, int height, int columns, const int* rows, double* x, const double* all)
{
  backward_together(panel, height, columns, rows, x, all);
}

VESICLE_MULTIVERSION
void solve_backward_together(
  const float* panel, int height, int columns, const int* rows, float* x, const float* all)
{
  backward_together(panel, height, columns, rows, x, all);
}

template bool factorize_panel(double*, int, int, double*, std::vector<double>&);
template bool factorize_panel(float*, int, int, float*, std::vector<float>&);
template void subtract_outer_product(
  double*, int, const double*, int, int, const double*, std::vector<double>&);
template void subtract_outer_product(
  float*, int, const float*, int, int, const float*, std::vector<float>&);

}
