#pragma once

namespace vesicle
{

/// block(i, j) += factor · a_i b_j, `rows` by `columns` by rows. Hidden: a program and a shared library
/// that both hold the solver each choose their own instruction set.
[[gnu::visibility("hidden")]] void add_outer_product(
  int rows, int columns, double factor, const double* a, const double* b, double* block);

}
