#include "solver/linear/SparseCholesky.h"

#include "solver/Lanes.h"
#include "solver/linear/Blas.h"
#include "solver/linear/DensePanel.h"
#include "solver/linear/FlushDenormals.h"

namespace vesicle
{

namespace
{

using Supernode = EliminationPlan::Supernode;

// A child's change, of its rows, in its parent's panel and, below it, in the parent's own change.
template<class Scalar>
void hand_up(const std::vector<Scalar>& change, const std::vector<int>& place,
  const Supernode& parent, Scalar* panel, Scalar* parents_change)
{
  const std::size_t n = place.size();
  const auto rows = static_cast<std::ptrdiff_t>(parent.rows.size());
  for (std::size_t j = 0; j < n; ++j)
  {
    Scalar* to = place[j] < parent.columns
      ? panel + static_cast<std::ptrdiff_t>(place[j]) * parent.height()
      : parents_change + (place[j] - parent.columns) * rows - parent.columns;
    const Scalar* from = change.data() + j * n;
    for (std::size_t i = j; i < n; ++i)
      to[place[i]] += from[i];
  }
}

}

template<class Scalar>
void SupernodalCholesky<Scalar>::compute(const SymmetricMatrix& A)
{
  if (!plan_ || !plan_->fits(A))
    plan_ = std::make_shared<const EliminationPlan>(A);
  regular_ = factorize(A);
}

template<class Scalar>
void SupernodalCholesky<Scalar>::compute(const SymmetricMatrix& A, const EliminationPlans& plans)
{
  if (!plan_ || !plan_->fits(A))
    plan_ = plans.of(A);
  regular_ = factorize(A);
}

template<class Scalar>
bool SupernodalCholesky<Scalar>::factorize(const SymmetricMatrix& A)
{
  const FlushDenormals flush;
  use_one_blas_thread();
  panels_.assign(plan_->panel_entries(), 0);
  pivots_.resize(plan_->size());
  for (Eigen::Index k = 0; k < A.nonZeros(); ++k)
    if (plan_->targets()[k] >= 0)
      panels_[plan_->targets()[k]] += static_cast<Scalar>(A.valuePtr()[k]);

  const std::vector<Supernode>& supernodes = plan_->supernodes();
  std::vector<std::vector<int>> children(supernodes.size());
  // What each supernode changes in the rows below it, until its parent has it.
  std::vector<std::vector<Scalar>> changes(supernodes.size());
  std::vector<Scalar> work;
  for (std::size_t s = 0; s < supernodes.size(); ++s)
  {
    const Supernode& node = supernodes[s];
    const int rows = static_cast<int>(node.rows.size());
    Scalar *panel = panels_.data() + node.offset, *pivots = pivots_.data() + node.first;
    std::vector<Scalar>& change = changes[s];
    change.assign(static_cast<std::size_t>(rows) * rows, 0);
    for (const int c : children[s])
    {
      hand_up(changes[c], supernodes[c].place, node, panel, change.data());
      std::vector<Scalar>().swap(changes[c]);
    }
    if (!factorize_panel(panel, node.height(), node.columns, pivots, work))
      return false;
    if (node.parent < 0)
      continue;
    subtract_outer_product(
      change.data(), rows, panel + node.columns, node.height(), node.columns, pivots, work);
    children[node.parent].push_back(static_cast<int>(s));
  }
  return true;
}

template<class Scalar>
void SupernodalCholesky<Scalar>::solve_column(Scalar* column) const
{
  const FlushDenormals flush;
  const std::vector<Supernode>& supernodes = plan_->supernodes();
  std::vector<Scalar> below(plan_->size());
  for (const Supernode& s : supernodes)
  {
    const Scalar* panel = panels_.data() + s.offset;
    const int rows = static_cast<int>(s.rows.size());
    for (int i = 0; i < rows; ++i)
      below[i] = column[s.rows[i]];
    solve_forward(panel, s.height(), s.columns, column + s.first, below.data());
    for (int i = 0; i < rows; ++i)
      column[s.rows[i]] = below[i];
  }
  Eigen::Map<Vector>(column, pivots_.size()).array() /= pivots_.array();
  for (std::size_t last = supernodes.size(); last-- > 0;)
  {
    const Supernode& s = supernodes[last];
    const Scalar* panel = panels_.data() + s.offset;
    const int rows = static_cast<int>(s.rows.size());
    for (int i = 0; i < rows; ++i)
      below[i] = column[s.rows[i]];
    solve_backward(panel, s.height(), s.columns, column + s.first, below.data());
  }
}

template<class Scalar>
void SupernodalCholesky<Scalar>::solve_together(Scalar* columns) const
{
  static_assert(columns_at_once == lanes);
  const FlushDenormals flush;
  const std::vector<Supernode>& supernodes = plan_->supernodes();
  for (const Supernode& s : supernodes)
    solve_forward_together(panels_.data() + s.offset, s.height(), s.columns, s.rows.data(),
      columns + static_cast<std::ptrdiff_t>(s.first) * lanes, columns);
  for (Eigen::Index i = 0; i < pivots_.size(); ++i)
    for (int c = 0; c < lanes; ++c)
      columns[i * lanes + c] /= pivots_[i];
  for (std::size_t last = supernodes.size(); last-- > 0;)
  {
    const Supernode& s = supernodes[last];
    solve_backward_together(panels_.data() + s.offset, s.height(), s.columns, s.rows.data(),
      columns + static_cast<std::ptrdiff_t>(s.first) * lanes, columns);
  }
}

template class SupernodalCholesky<double>;
template class SupernodalCholesky<float>;

}
