#include "solver/surface/ElementPattern.h"

#include "solver/Lanes.h"
#include "solver/surface/ElementProduct.h"

#include <algorithm>

namespace vesicle
{

ElementPattern::ElementPattern(const BasisTable& table) : start_(table.nodes + 1, 0)
{
  std::vector<std::vector<int>> partners(table.nodes);
  Eigen::Index pairs = 0;
  for_each_element(table,
    [&](int begin, int end, std::span<const int> nodes)
    {
      elements_.push_back({ begin, end, static_cast<int>(nodes.size()), pairs });
      pairs += static_cast<Eigen::Index>(nodes.size() * nodes.size());
      for (const int i : nodes)
        partners[i].insert(partners[i].end(), nodes.begin(), nodes.end());
    });
  for (int i = 0; i < table.nodes; ++i)
  {
    std::vector<int>& own = partners[i];
    std::sort(own.begin(), own.end());
    own.erase(std::unique(own.begin(), own.end()), own.end());
    partner_.insert(partner_.end(), own.begin(), own.end());
    start_[i + 1] = static_cast<int>(partner_.size());
  }
  places_.reserve(pairs);
  for (const Element& e : elements_)
  {
    const auto nodes = std::span(table.node).subspan(table.start[e.begin], e.width);
    for (const int i : nodes)
      for (const int j : nodes)
        places_.push_back(static_cast<int>(
          std::lower_bound(partner_.begin() + start_[i], partner_.begin() + start_[i + 1], j) -
          partner_.begin()));
  }
}

std::shared_ptr<const ElementPattern> pattern_of(const BasisTable& table)
{
  return table.pattern ? table.pattern : std::make_shared<const ElementPattern>(table);
}

template<int rows, int columns>
ElementSum<rows, columns>::ElementSum(const ElementPattern& pattern)
  : pattern_(pattern), values_(pattern.partner().size() * rows * columns, 0)
{
}

template<int rows, int columns>
void ElementSum<rows, columns>::begin(const ElementPattern::Element& element)
{
  element_ = &element;
  products_ = 0;
}

template<int rows, int columns>
void ElementSum<rows, columns>::add_outer_product(double factor, const double* a, const double* b)
{
  const int m = rows * element_->width, n = columns * element_->width;
  const std::size_t at = products_++;
  a_.resize(std::max(a_.size(), products_ * in_lanes(m)));
  b_.resize(std::max(b_.size(), products_ * in_lanes(n)));
  std::transform(a, a + m, a_.data() + at * in_lanes(m), [=](double x) { return factor * x; });
  std::copy(b, b + n, b_.data() + at * in_lanes(n));
}

template<int rows, int columns>
void ElementSum<rows, columns>::end()
{
  const int width = element_->width, stride = in_lanes(columns * width);
  block_.resize(static_cast<std::size_t>(in_lanes(rows * width)) * stride);
  multiply_rows(static_cast<int>(products_), rows * width, columns * width, a_.data(), b_.data(),
    block_.data());
  const int* place = pattern_.places().data() + element_->first_pair;
  for (int i = 0; i < width; ++i, place += width)
  {
    const int node = pattern_.partner()[place[i]], first = pattern_.start()[node],
              row_size = (pattern_.start()[node + 1] - first) * columns;
    double* to = values_.data() + static_cast<std::size_t>(first) * rows * columns;
    const double* from = block_.data() + static_cast<std::size_t>(i) * rows * stride;
    for (int j = 0; j < width; ++j)
      for (int a = 0; a < rows; ++a)
        for (int b = 0; b < columns; ++b)
          to[a * row_size + (place[j] - first) * columns + b] += from[a * stride + j * columns + b];
  }
}

template<int rows, int columns>
SparseMatrix ElementSum<rows, columns>::total(std::span<const ElementSum> sums)
{
  const ElementPattern& pattern = sums.front().pattern_;
  const int nodes = pattern.nodes();
  SparseMatrix sum(
    static_cast<Eigen::Index>(rows) * nodes, static_cast<Eigen::Index>(columns) * nodes);
  const auto size = static_cast<int>(sums.front().values_.size());
  sum.resizeNonZeros(size);
  sum.outerIndexPtr()[rows * nodes] = size;
  constexpr int grain = 64;
  parallel_for(
    nodes,
    [&](int i)
    {
      const int first = pattern.start()[i], pairs = pattern.start()[i + 1] - first;
      const int begin = first * rows * columns, end = begin + pairs * rows * columns;
      int next = begin;
      for (int a = 0; a < rows; ++a)
      {
        sum.outerIndexPtr()[i * rows + a] = next;
        for (int p = first; p < first + pairs; ++p)
          for (int b = 0; b < columns; ++b, ++next)
            sum.innerIndexPtr()[next] = pattern.partner()[p] * columns + b;
      }
      std::copy(sums.front().values_.data() + begin, sums.front().values_.data() + end,
        sum.valuePtr() + begin);
      for (const ElementSum& part : sums.subspan(1))
        for (int k = begin; k < end; ++k)
          sum.valuePtr()[k] += part.values_[k];
    },
    grain);
  return sum;
}

template class ElementSum<1, 1>;
template class ElementSum<1, 3>;
template class ElementSum<3, 3>;

}
