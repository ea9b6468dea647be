#include "solver/linear/EliminationPlan.h"

#include <Eigen/OrderingMethods>

#include <algorithm>
#include <span>

namespace vesicle
{

namespace
{

using Lists = std::vector<std::vector<int>>;

// The share of zeros that a supernode may store: dense products of wide panels are worth some.
double allowed_zeros(int columns)
{
  return columns <= 4 ? 1 : columns <= 16 ? 0.8 : columns <= 48 ? 0.1 : 0.05;
}

std::vector<int> least_fill(const SymmetricMatrix& A)
{
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  const SymmetricMatrix whole = A.selfadjointView<Eigen::Lower>();
  Eigen::AMDOrdering<int>()(whole, order);
  std::vector<int> position(A.cols());
  for (int i = 0; i < A.cols(); ++i)
    position[order.indices()[i]] = i;
  return position;
}

// Of each column in its new place: the rows above the diagonal.
Lists rows_above(const SymmetricMatrix& A, const std::vector<int>& position)
{
  Lists above(A.cols());
  for (int j = 0; j < A.cols(); ++j)
    for (SymmetricMatrix::InnerIterator it(A, j); it; ++it)
      if (it.row() > j)
      {
        const auto [small, large] = std::minmax(position[it.row()], position[j]);
        above[large].push_back(small);
      }
  return above;
}

Lists transposed(const Lists& above)
{
  Lists below(above.size());
  for (int k = 0; k < static_cast<int>(above.size()); ++k)
    for (const int i : above[k])
      below[i].push_back(k);
  return below;
}

// The first row below the diagonal of each column of the factor; −1: none.
std::vector<int> elimination_tree(const Lists& above)
{
  const int n = static_cast<int>(above.size());
  std::vector<int> parent(n, -1), ancestor(n, -1);
  for (int k = 0; k < n; ++k)
    for (int i : above[k])
      while (i != -1 && i < k)
      {
        const int next = ancestor[i];
        ancestor[i] = k;
        if (next == -1)
          parent[i] = k;
        i = next;
      }
  return parent;
}

// Children before their parents, each subtree without a gap.
std::vector<int> postorder(const std::vector<int>& parent)
{
  const int n = static_cast<int>(parent.size());
  std::vector<int> child(n, -1), sibling(n, -1), path, order;
  for (int i = n - 1; i >= 0; --i)
    if (parent[i] >= 0)
    {
      sibling[i] = child[parent[i]];
      child[parent[i]] = i;
    }
  for (int root = 0; root < n; ++root)
  {
    if (parent[root] >= 0)
      continue;
    path.push_back(root);
    while (!path.empty())
    {
      const int i = path.back(), next = child[i];
      if (next >= 0)
      {
        path.push_back(next);
        child[i] = sibling[next];
        continue;
      }
      order.push_back(i);
      path.pop_back();
    }
  }
  return order;
}

// Entries of each column of the factor, with the diagonal's.
std::vector<int> column_counts(const std::vector<int>& parent, const Lists& above)
{
  const int n = static_cast<int>(parent.size());
  std::vector<int> count(n, 1), seen(n, -1);
  for (int k = 0; k < n; ++k)
  {
    seen[k] = k;
    for (int i : above[k])
      for (; seen[i] != k; i = parent[i])
      {
        seen[i] = k;
        ++count[i];
      }
  }
  return count;
}

}

EliminationPlan::EliminationPlan(const SymmetricMatrix& A)
  : outer_(A.outerIndexPtr(), A.outerIndexPtr() + A.cols() + 1),
    inner_(A.innerIndexPtr(), A.innerIndexPtr() + A.nonZeros()), position_(least_fill(A))
{
  const std::vector<int> order = postorder(elimination_tree(rows_above(A, position_)));
  std::vector<int> place(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    place[order[i]] = static_cast<int>(i);
  for (int& position : position_)
    position = place[position];
  const Lists above = rows_above(A, position_);
  const std::vector<int> parent = elimination_tree(above);
  find_supernodes(parent, column_counts(parent, above));
  find_rows(transposed(above));
  find_targets(A);
}

bool EliminationPlan::fits(const SymmetricMatrix& A) const
{
  return A.cols() == size() && A.nonZeros() == static_cast<Eigen::Index>(inner_.size()) &&
    std::equal(outer_.begin(), outer_.end(), A.outerIndexPtr()) &&
    std::equal(inner_.begin(), inner_.end(), A.innerIndexPtr());
}

// Each column joins those before it while the zeros are few; only its last child's can be next to it.
void EliminationPlan::find_supernodes(const std::vector<int>& parent, const std::vector<int>& count)
{
  struct Run
  {
    int first, columns, height; ///< height: of the first column
    double entries;             ///< that aren't zero
  };
  std::vector<Run> runs;
  for (int j = 0; j < size(); ++j)
  {
    Run run{ j, 1, count[j], static_cast<double>(count[j]) };
    while (!runs.empty())
    {
      const Run& last = runs.back();
      const int up = parent[last.first + last.columns - 1];
      if (up < run.first || up >= run.first + run.columns)
        break;
      const int columns = last.columns + run.columns, height = last.columns + run.height;
      const double stored = columns * (height - (columns - 1) / 2.),
                   entries = last.entries + run.entries;
      if (1 - entries / stored > allowed_zeros(columns))
        break;
      run = { last.first, columns, height, entries };
      runs.pop_back();
    }
    runs.push_back(run);
  }
  for (const Run& run : runs)
    supernodes_.push_back({ run.first, run.columns, -1, {}, {}, 0 });
  const std::vector<int> owner = owners();
  for (Supernode& s : supernodes_)
    if (const int up = parent[s.first + s.columns - 1]; up >= 0)
      s.parent = owner[up];
}

std::vector<int> EliminationPlan::owners() const
{
  std::vector<int> owner(size());
  for (std::size_t s = 0; s < supernodes_.size(); ++s)
    std::fill_n(owner.begin() + supernodes_[s].first, supernodes_[s].columns, static_cast<int>(s));
  return owner;
}

// Those of its own columns' entries and its children's.
void EliminationPlan::find_rows(const Lists& below)
{
  Lists children(supernodes_.size());
  std::vector<int> seen(size(), -1), place(size());
  for (int s = 0; s < static_cast<int>(supernodes_.size()); ++s)
  {
    Supernode& node = supernodes_[s];
    const int end = node.first + node.columns;
    const auto add = [&](std::span<const int> rows)
    {
      for (const int i : rows)
        if (i >= end && seen[i] != s)
        {
          seen[i] = s;
          node.rows.push_back(i);
        }
    };
    for (int j = node.first; j < end; ++j)
      add(below[j]);
    for (const int c : children[s])
      add(supernodes_[c].rows);
    std::sort(node.rows.begin(), node.rows.end());
    for (int j = 0; j < node.columns; ++j)
      place[node.first + j] = j;
    for (std::size_t i = 0; i < node.rows.size(); ++i)
      place[node.rows[i]] = node.columns + static_cast<int>(i);
    for (const int c : children[s])
      for (const int i : supernodes_[c].rows)
        supernodes_[c].place.push_back(place[i]);
    node.offset = panel_entries_;
    panel_entries_ += static_cast<Eigen::Index>(node.height()) * node.columns;
    if (node.parent >= 0)
      children[node.parent].push_back(s);
  }
}

void EliminationPlan::find_targets(const SymmetricMatrix& A)
{
  const std::vector<int> owner = owners();
  targets_.assign(A.nonZeros(), -1);
  for (int j = 0; j < A.cols(); ++j)
    for (int k = outer_[j]; k < outer_[j + 1]; ++k)
    {
      if (inner_[k] < j)
        continue;
      const auto [column, row] = std::minmax(position_[inner_[k]], position_[j]);
      const Supernode& s = supernodes_[owner[column]];
      const Eigen::Index down = row < s.first + s.columns
        ? row - s.first
        : s.columns + (std::lower_bound(s.rows.begin(), s.rows.end(), row) - s.rows.begin());
      targets_[k] = s.offset + static_cast<Eigen::Index>(column - s.first) * s.height() + down;
    }
}

}
