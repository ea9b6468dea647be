#pragma once
// LDLᵀ of sparse symmetric matrices. Nearly all work is products of dense matrices, OpenBLAS's.

#include "solver/linear/EliminationPlans.h"

#include <algorithm>

namespace vesicle
{

/// Of matrices whose leading blocks are all regular, indefinite or not: nothing is pivoted. Scalar:
/// double or float, of the factors. A float's solution has an error of 1e-7 times the matrix's
/// condition: enough for a preconditioner. Multifrontal, a supernode after the other.
template<class Scalar>
class SupernodalCholesky
{
public:
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

  SupernodalCholesky() = default;
  explicit SupernodalCholesky(const SymmetricMatrix& A) { compute(A); }
  SupernodalCholesky(const SymmetricMatrix& A, const EliminationPlans& plans) { compute(A, plans); }
  /// Of the lower triangle. A pattern that is the last one's isn't analysed again.
  void compute(const SymmetricMatrix& A);
  /// Nor one that `plans` knows.
  void compute(const SymmetricMatrix& A, const EliminationPlans& plans);
  /// False where a pivot was zero or not finite.
  bool regular() const { return regular_; }
  /// D: as many are negative as the matrix has negative eigenvalues.
  const Vector& pivots() const { return pivots_; }

  /// A⁻¹ b, b of one or more columns.
  template<class Derived>
  typename Derived::PlainObject solve(const Eigen::MatrixBase<Derived>& b) const
  {
    typename Derived::PlainObject x = b;
    for (Eigen::Index first = 0; first < x.cols(); first += columns_at_once)
    {
      const Eigen::Index columns = std::min<Eigen::Index>(columns_at_once, x.cols() - first);
      solve_some(x.middleCols(first, columns));
    }
    return x;
  }

private:
  static constexpr int columns_at_once = 4;

  bool factorize(const SymmetricMatrix& A);
  template<class Some>
  void solve_some(Some&& x) const
  {
    const std::vector<int>& position = plan_->position();
    const Eigen::Index width = x.cols() == 1 ? 1 : columns_at_once;
    Vector reordered = Vector::Zero(width * x.rows());
    for (Eigen::Index i = 0; i < x.rows(); ++i)
      for (Eigen::Index c = 0; c < x.cols(); ++c)
        reordered[width * position[i] + c] = static_cast<Scalar>(x(i, c));
    if (width == 1)
      solve_column(reordered.data());
    else
      solve_together(reordered.data());
    for (Eigen::Index i = 0; i < x.rows(); ++i)
      for (Eigen::Index c = 0; c < x.cols(); ++c)
        x(i, c) = static_cast<double>(reordered[width * position[i] + c]);
  }
  void solve_column(Scalar* column) const;
  /// The columns' numbers side by side.
  void solve_together(Scalar* columns) const;

  std::shared_ptr<const EliminationPlan> plan_;
  std::vector<Scalar> panels_; ///< L, unit lower triangles on top
  Vector pivots_;
  bool regular_ = false;
};

using SparseCholesky = SupernodalCholesky<double>;

extern template class SupernodalCholesky<double>;
extern template class SupernodalCholesky<float>;

}
