#pragma once
// The dense parts of SparseCholesky.h, in single and double precision. Matrices are by columns.

#include <vector>

namespace vesicle
{

/// The first `columns` columns of a symmetric matrix of `height` rows, by its lower triangle, become
/// those of its L, D goes to `pivots`. False: a pivot is zero or not finite.
template<class Scalar>
bool factorize_panel(
  Scalar* panel, int height, int columns, Scalar* pivots, std::vector<Scalar>& work);

/// The lower triangle of U, `rows` by `rows`, less that of L D Lᵀ; L has `height` entries from one
/// column to the next.
template<class Scalar>
void subtract_outer_product(Scalar* U, int rows, const Scalar* L, int height, int columns,
  const Scalar* pivots, std::vector<Scalar>& work);

/// x ← L⁻¹ x of the unit lower triangle on top of a panel; below ← below − A x of the rows under it.
/// Hidden: a program and a shared library that both hold the solver each choose their own instruction set.
[[gnu::visibility("hidden")]] void solve_forward(
  const double* panel, int height, int columns, double* x, double* below);
[[gnu::visibility("hidden")]] void solve_forward(
  const float* panel, int height, int columns, float* x, float* below);
/// x ← L⁻ᵀ(x − Aᵀ below).
[[gnu::visibility("hidden")]] void solve_backward(
  const double* panel, int height, int columns, double* x, const double* below);
[[gnu::visibility("hidden")]] void solve_backward(
  const float* panel, int height, int columns, float* x, const float* below);

/// The same of `lanes` right sides at once (Lanes.h), their numbers side by side: x those of the panel's
/// columns, `all` those of all rows, `rows` the numbers of the rows below.
[[gnu::visibility("hidden")]] void solve_forward_together(
  const double* panel, int height, int columns, const int* rows, double* x, double* all);
[[gnu::visibility("hidden")]] void solve_forward_together(
  const float* panel, int height, int columns, const int* rows, float* x, float* all);
[[gnu::visibility("hidden")]] void solve_backward_together(
  const double* panel, int height, int columns, const int* rows, double* x, const double* all);
[[gnu::visibility("hidden")]] void solve_backward_together(
  const float* panel, int height, int columns, const int* rows, float* x, const float* all);

}
