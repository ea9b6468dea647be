#pragma once
// The inner loops over the rows of a basis table, compiled for several instruction sets. A field is a
// number of every entry: N_k or one of its derivatives.

#include "solver/surface/Basis.h"

namespace vesicle
{

/// Vectors of three numbers as these loops want them: x, y, z, 0.
using PaddedPoints = Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor>;
PaddedPoints padded(const Points& points);

/// std::vector<double> of a table each.
auto fields_of(const auto&... of_entries)
{
  return std::array{ of_entries.data()... };
}

/// Rows [begin, end) of a table, and one, two, three or five fields of its entries.
struct FieldRows
{
  const BasisTable& table;
  std::span<const double* const> fields;
  int begin, end;

  int rows() const { return end - begin; }
};

// Hidden: a program and a shared library that both hold the solver each choose their own instruction set.

/// Σ_k field_k x_k over the entries of each row, of each field, one or three: sums[field] has `stride` numbers a
/// component, one for every row of the table.
[[gnu::visibility("hidden")]] void sum_over_entries(
  const FieldRows& rows, const PaddedPoints& nodes, std::span<double* const> sums, long stride);

/// Its transpose: x_k += Σ_fields field_k f for each entry, f in `of_rows`, rows by fields.
[[gnu::visibility("hidden")]] void add_to_nodes(
  const FieldRows& rows, const double* of_rows, PaddedPoints& nodes);

/// Σ_fields field_k f of every entry: 3 numbers each, in their order; f as above.
[[gnu::visibility("hidden")]] void combine_vectors(
  const FieldRows& rows, const double* of_rows, double* entries);

/// The same of numbers f, rows by fields.
[[gnu::visibility("hidden")]] void combine_numbers(
  const FieldRows& rows, const double* of_rows, double* entries);

}
