#pragma once
// Sums over a table's rows that add to the nodes which a row feels.

#include "solver/ParallelFor.h"
#include "solver/surface/Basis.h"

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

}
