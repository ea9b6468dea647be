#include "solver/surface/ElementPattern.h"

#include "solver/surface/OuterProduct.h"

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

ElementSum::ElementSum(const ElementPattern& pattern, int rows, int columns)
  : pattern_(pattern), rows_(rows), columns_(columns),
    values_(pattern.partner().size() * rows * columns, 0)
{
}

void ElementSum::begin(const ElementPattern::Element& element)
{
  element_ = &element;
  block_.assign(static_cast<std::size_t>(element.width) * element.width * rows_ * columns_, 0);
}

void ElementSum::add_outer_product(double factor, const double* a, const double* b)
{
  vesicle::add_outer_product(
    rows_ * element_->width, columns_ * element_->width, factor, a, b, block_.data());
}

void ElementSum::end()
{
  const int width = element_->width, size = rows_ * columns_;
  const int* place = pattern_.places().data() + element_->first_pair;
  for (int i = 0; i < width; ++i)
    for (int j = 0; j < width; ++j, ++place)
    {
      double* to = values_.data() + static_cast<std::size_t>(*place) * size;
      for (int a = 0; a < rows_; ++a)
        for (int b = 0; b < columns_; ++b)
          to[a * columns_ + b] +=
            block_[(static_cast<std::size_t>(i) * rows_ + a) * width * columns_ + j * columns_ + b];
    }
}

ElementSum& ElementSum::operator+=(const ElementSum& other)
{
  for (std::size_t i = 0; i < values_.size(); ++i)
    values_[i] += other.values_[i];
  return *this;
}

SparseMatrix ElementSum::matrix() const
{
  const int nodes = pattern_.nodes();
  SparseMatrix sum(
    static_cast<Eigen::Index>(rows_) * nodes, static_cast<Eigen::Index>(columns_) * nodes);
  sum.resizeNonZeros(static_cast<Eigen::Index>(values_.size()));
  int next = 0;
  for (int i = 0; i < nodes; ++i)
    for (int a = 0; a < rows_; ++a)
    {
      sum.outerIndexPtr()[i * rows_ + a] = next;
      for (int p = pattern_.start()[i]; p < pattern_.start()[i + 1]; ++p)
        for (int b = 0; b < columns_; ++b, ++next)
        {
          sum.innerIndexPtr()[next] = pattern_.partner()[p] * columns_ + b;
          sum.valuePtr()[next] = values_[(static_cast<std::size_t>(p) * rows_ + a) * columns_ + b];
        }
    }
  sum.outerIndexPtr()[rows_ * nodes] = next;
  return sum;
}

}
