#pragma once
// Sums over a table's rows that add to the nodes which a row feels.

#include "solver/ParallelFor.h"
#include "solver/surface/TableLoops.h"

#include <algorithm>
#include <array>

namespace vesicle
{

/// Calls add(sum, row) for each row of the table, where `sum` has a row of `columns` numbers a node.
/// Threads share the table's parts, whose sums are added up in their order: results do not depend on
/// the threads' number.
template<int columns, class Add>
auto nodal_sum(const BasisTable& table, Add add)
{
  using Sum = Eigen::Matrix<double, Eigen::Dynamic, columns, columns == 1 ? 0 : Eigen::RowMajor>;
  constexpr int parts = 8;
  std::array<Sum, parts> sums;
  const int rows = table.rows();
  parallel_for(parts,
    [&](int part)
    {
      sums[part] = Sum::Zero(table.nodes, columns);
      const auto first = [&](int p)
      { return static_cast<int>(static_cast<long>(rows) * p / parts); };
      for (int q = first(part); q < first(part + 1); ++q)
        add(sums[part], q);
    });
  for (int part = 1; part < parts; ++part)
    sums[0] += sums[part];
  return Sum(std::move(sums[0]));
}

/// use(rows, numbers) block by block of rows [begin, end), with what at_row(q) has for each field, 3 by
/// fields, as the loops of TableLoops.h want it.
template<std::size_t fields, class AtRow, class Use>
void for_each_block(const BasisTable& table, const std::array<const double*, fields>& of_entries,
  int begin, int end, AtRow at_row, Use use)
{
  constexpr int block = 16;
  using Padded = Eigen::Matrix<double, 4, static_cast<int>(fields)>;
  std::array<double, block * fields * 4> numbers{};
  for (int q = begin; q < end; q += block)
  {
    const FieldRows rows{ table, of_entries, q, std::min(q + block, end) };
    for (int r = 0; r < rows.rows(); ++r)
      Eigen::Map<Padded>(numbers.data() + r * fields * 4).template topRows<3>() = at_row(q + r);
    use(rows, numbers.data());
  }
}

/// The gradient with respect to the nodes, 3N, of a sum over the table's rows: at_row(q) is the row's with
/// respect to each of the fields Σ_k field_k x_k, 3 by fields. As nodal_sum, whatever the threads' number.
template<std::size_t fields, class AtRow>
Eigen::VectorXd nodal_gradient(
  const BasisTable& table, const std::array<const double*, fields>& of_entries, AtRow at_row)
{
  constexpr int parts = 8;
  std::array<PaddedPoints, parts> sums;
  const auto first = [&](int part)
  { return static_cast<int>(static_cast<long>(table.rows()) * part / parts); };
  parallel_for(parts,
    [&](int part)
    {
      PaddedPoints& sum = sums[part] = PaddedPoints::Zero(table.nodes, 4);
      for_each_block(table, of_entries, first(part), first(part + 1), at_row,
        [&](const FieldRows& rows, const double* numbers) { add_to_nodes(rows, numbers, sum); });
    });
  for (int part = 1; part < parts; ++part)
    sums[0] += sums[part];
  return sums[0].template leftCols<3>().template reshaped<Eigen::RowMajor>();
}

/// The gradients with respect to the node of every entry, one by one: of each row by at_row as above.
template<std::size_t fields, class AtRow>
EntryVectors entry_gradients(
  const BasisTable& table, const std::array<const double*, fields>& of_entries, AtRow at_row)
{
  constexpr int task_rows = 256; // some ten thousand operations
  EntryVectors entries(table.node.size(), 3);
  parallel_for((table.rows() + task_rows - 1) / task_rows,
    [&](int task)
    {
      for_each_block(table, of_entries, task * task_rows,
        std::min((task + 1) * task_rows, table.rows()), at_row,
        [&](const FieldRows& rows, const double* numbers)
        { combine_vectors(rows, numbers, entries.data()); });
    });
  return entries;
}

}
