#include "solver/linear/SmallLeastSquares.h"

#include "solver/Lanes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace vesicle
{

namespace
{

// n is a multiple of `lanes`.

VESICLE_INLINE double dot(const double* a, const double* b, int n)
{
  Lanes sum{};
  for (int i = 0; i < n; i += lanes)
    sum += lanes_at(a + i) * lanes_at(b + i);
  return sum_of(sum);
}

VESICLE_INLINE void scale(double factor, double* a, int n)
{
  for (int i = 0; i < n; i += lanes)
    lanes_at(a + i) *= factor;
}

VESICLE_INLINE void add(double factor, const double* a, double* to, int n)
{
  for (int i = 0; i < n; i += lanes)
    lanes_at(to + i) += factor * lanes_at(a + i);
}

/// `stride` numbers each.
struct Columns
{
  double* first;
  int stride;
  VESICLE_INLINE double* operator[](int j) const { return first + static_cast<long>(j) * stride; }
};

// Four columns at once, since sums that wait for each other leave the processor idle.
constexpr int together = 4;

/// What the columns have of the unit vector q goes to `part` and is taken from them.
VESICLE_INLINE void take_out(
  const double* q, const Columns& columns, const int* which, double* part)
{
  double *const a = columns[which[0]], *const b = columns[which[1]], *const c = columns[which[2]],
                *const d = columns[which[3]];
  Lanes in_a{}, in_b{}, in_c{}, in_d{};
  for (int i = 0; i < columns.stride; i += lanes)
  {
    in_a += lanes_at(q + i) * lanes_at(a + i);
    in_b += lanes_at(q + i) * lanes_at(b + i);
    in_c += lanes_at(q + i) * lanes_at(c + i);
    in_d += lanes_at(q + i) * lanes_at(d + i);
  }
  const double of_a = part[which[0]] = sum_of(in_a), of_b = part[which[1]] = sum_of(in_b),
               of_c = part[which[2]] = sum_of(in_c), of_d = part[which[3]] = sum_of(in_d);
  for (int i = 0; i < columns.stride; i += lanes)
  {
    const Lanes along = lanes_at(q + i);
    lanes_at(a + i) -= of_a * along;
    lanes_at(b + i) -= of_b * along;
    lanes_at(c + i) -= of_c * along;
    lanes_at(d + i) -= of_d * along;
  }
}

/// Makes the first `count` columns orthonormal, in the order of how much of their length is left,
/// and takes what they span out of the one after them. `order` goes on with that one and as many
/// zero columns as a last four may need; `left` are squared shares of the lengths, R has a row a
/// column chosen. False as SmallLeastSquares::solve.
VESICLE_MULTIVERSION
bool orthonormalize(const Columns& A, int count, double threshold, int* order, double* length,
  double* left, double* R)
{
  for (int j = 0; j < count; ++j)
    length[j] = std::sqrt(dot(A[j], A[j], A.stride));
  std::fill_n(left, count, 1.);
  for (int k = 0; k < count; ++k, R += count + 2)
  {
    const auto longest =
      std::max_element(order + k, order + count, [&](int i, int j) { return left[i] < left[j]; });
    std::swap(order[k], *longest);
    double* const q = A[order[k]];
    const double remaining = std::sqrt(dot(q, q, A.stride));
    if (!(remaining > threshold * length[order[k]]))
      return false;
    scale(1 / remaining, q, A.stride);
    R[order[k]] = remaining;
    for (int m = k + 1; m <= count; m += together)
      take_out(q, A, order + m, R);
    for (int m = k + 1; m < count; ++m)
    {
      const double share = R[order[m]] / length[order[m]];
      left[order[m]] -= share * share;
    }
  }
  return true;
}

/// Σ_k factor_k column order_k
VESICLE_MULTIVERSION
void combine(const Columns& Q, int count, const int* order, const double* factor, double* sum)
{
  std::fill_n(sum, Q.stride, 0);
  for (int k = 0; k < count; ++k)
    add(factor[k], Q[order[k]], sum, Q.stride);
}

/// Each row's squared length.
VESICLE_MULTIVERSION
void measure_rows(const Columns& Q, int count, double* square)
{
  std::fill_n(square, Q.stride, 0);
  for (int k = 0; k < count; ++k)
    for (int i = 0; i < Q.stride; i += lanes)
      lanes_at(square + i) += lanes_at(Q[k] + i) * lanes_at(Q[k] + i);
}

}

void SmallLeastSquares::resize(int rows, int unknowns)
{
  rows_ = rows;
  unknowns_ = unknowns;
  stride_ = in_lanes(rows);
  const int columns = unknowns + 2; // with the right side and one of zeros
  columns_.resize(static_cast<std::size_t>(stride_) * columns);
  for (int j = 0; j < columns - 1; ++j)
    std::fill(column(j) + rows, column(j) + stride_, 0);
  std::fill_n(column(columns - 1), stride_, 0);
  order_.assign(unknowns + together, columns - 1);
  std::iota(order_.begin(), order_.begin() + columns, 0);
  length_.resize(columns);
  left_.resize(unknowns);
  R_.resize(static_cast<std::size_t>(unknowns) * columns);
}

bool SmallLeastSquares::solve(double threshold)
{
  const Columns A{ columns_.data(), stride_ };
  if (!orthonormalize(
        A, unknowns_, threshold, order_.data(), length_.data(), left_.data(), R_.data()))
    return false;
  residual_ = std::sqrt(dot(right_side(), right_side(), stride_));
  substitute_back();
  return true;
}

void SmallLeastSquares::substitute_back()
{
  solution_.resize(unknowns_);
  for (int k = unknowns_ - 1; k >= 0; --k)
  {
    double sum = R(k, unknowns_);
    for (int m = k + 1; m < unknowns_; ++m)
      sum -= R(k, order_[m]) * solution_[order_[m]];
    solution_[order_[k]] = sum / R(k, order_[k]);
  }
}

// w = Q R⁻ᵀ g
std::span<const double> SmallLeastSquares::functional(std::span<const double> g)
{
  multipliers_.resize(unknowns_);
  for (int k = 0; k < unknowns_; ++k)
  {
    double sum = g[order_[k]];
    for (int m = 0; m < k; ++m)
      sum -= R(m, order_[k]) * multipliers_[m];
    multipliers_[k] = sum / R(k, order_[k]);
  }
  of_rows_.resize(stride_);
  const Columns Q{ columns_.data(), stride_ };
  combine(Q, unknowns_, order_.data(), multipliers_.data(), of_rows_.data());
  return { of_rows_.data(), static_cast<std::size_t>(rows_) };
}

std::span<const double> SmallLeastSquares::leverages()
{
  of_rows_.resize(stride_);
  measure_rows({ columns_.data(), stride_ }, unknowns_, of_rows_.data());
  return { of_rows_.data(), static_cast<std::size_t>(rows_) };
}

}
