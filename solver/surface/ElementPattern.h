#pragma once
// Matrices over the nodes that are sums over elements: where their entries are, which the table alone
// decides, so that a sum needs no sorting.

#include "solver/ParallelFor.h"
#include "solver/surface/Basis.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace vesicle
{

/// Pairs of nodes that share an element.
class ElementPattern
{
public:
  explicit ElementPattern(const BasisTable& table);

  /// Rows [begin, end) of the table, which have the same `width` nodes.
  struct Element
  {
    int begin, end, width;
    Eigen::Index first_pair;
  };
  const std::vector<Element>& elements() const { return elements_; }
  /// Of each element's width² pairs, first nodes by second nodes: their places among all pairs.
  const std::vector<int>& places() const { return places_; }
  /// Node i's pairs are those from start[i] to start[i + 1], with the nodes partner[…], ascending.
  const std::vector<int>& start() const { return start_; }
  const std::vector<int>& partner() const { return partner_; }
  int nodes() const { return static_cast<int>(start_.size()) - 1; }

private:
  std::vector<Element> elements_;
  std::vector<int> places_, start_, partner_;
};

/// The table's, or one made now.
std::shared_ptr<const ElementPattern> pattern_of(const BasisTable& table);

/// A sum, element by element (element_sum()). A pair of nodes has a block of `rows` by `columns`
/// numbers: 1 by 1, 1 by 3 or 3 by 3.
template<int rows, int columns>
class ElementSum
{
public:
  /// The pattern must outlive the sum.
  explicit ElementSum(const ElementPattern& pattern);

  void begin(const ElementPattern::Element& element);
  /// factor · a bᵀ to the element begun, a of `rows`, b of `columns` numbers for each of its nodes.
  void add_outer_product(double factor, const double* a, const double* b);
  void end();

  /// Of sums of one pattern, in their order.
  static SparseMatrix total(std::span<const ElementSum> sums);
  SparseMatrix matrix() const { return total({ this, 1 }); }

private:
  const ElementPattern& pattern_;
  // Of the element begun: all a and b, which are multiplied when it ends.
  const ElementPattern::Element* element_ = nullptr;
  std::size_t products_ = 0;
  std::vector<double> a_, b_, block_;
  std::vector<double> values_; ///< the matrix's, by rows
};

extern template class ElementSum<1, 1>;
extern template class ElementSum<1, 3>;
extern template class ElementSum<3, 3>;

/// The matrix to which add(sum, row, first entry, width) adds the outer products of each row of the
/// table, `rows` times N by `columns` times N. Threads share the elements' parts, whose sums are added up
/// in their order: results do not depend on the threads' number.
template<int rows, int columns, class Add>
SparseMatrix element_sum(const BasisTable& table, Add add)
{
  constexpr std::size_t parts = 4;
  const auto pattern = pattern_of(table);
  const std::span all(pattern->elements());
  using Sum = ElementSum<rows, columns>;
  std::array<std::optional<Sum>, parts> made;
  parallel_for(parts,
    [&](std::size_t part)
    {
      Sum& sum = made[part].emplace(*pattern);
      const std::size_t first = all.size() * part / parts, last = all.size() * (part + 1) / parts;
      for (const ElementPattern::Element& e : all.subspan(first, last - first))
      {
        sum.begin(e);
        for (int q = e.begin; q < e.end; ++q)
          add(sum, q, table.start[q], e.width);
        sum.end();
      }
    });
  std::vector<Sum> sums;
  sums.reserve(parts);
  for (std::optional<Sum>& sum : made)
    sums.push_back(std::move(*sum));
  return Sum::total(sums);
}

}
