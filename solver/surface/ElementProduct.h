#pragma once

namespace vesicle
{

/// product(i, j) = Σ_q a_q(i) b_q(j), the rows a_q, b_q and those of the product in_lanes() of their
/// numbers apart; behind these numbers anything may stand. Hidden: a program and a shared library that
/// both hold the solver each choose their own instruction set.
[[gnu::visibility("hidden")]] void multiply_rows(
  int count, int rows, int columns, const double* a, const double* b, double* product);

}
