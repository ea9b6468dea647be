#pragma once
// LDLᵀ of sparse symmetric matrices. Nearly all work is products of dense matrices, OpenBLAS's.

#include "solver/linear/EliminationPlans.h"

namespace vesicle
{

/// Of matrices whose leading blocks are all regular, indefinite or not: nothing is pivoted. Scalar:
/// double or float, of the factors. A float's solution has an error of 1e-7 times the matrix's
/// condition: enough for a preconditioner. Multifrontal, a supernode after the other.
template<class Scalar>
class SupernodalCholesky
{
public:
  using Columns = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
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

  /// A⁻¹ b, b of one or more columns, which threads share.
  template<class Derived>
  typename Derived::PlainObject solve(const Eigen::MatrixBase<Derived>& b) const
  {
    const std::vector<int>& position = plan_->position();
    typename Derived::PlainObject x = b;
    Columns reordered(x.rows(), x.cols());
    for (Eigen::Index i = 0; i < x.rows(); ++i)
      reordered.row(position[i]) = x.row(i).template cast<Scalar>();
    solve_in_place(reordered);
    for (Eigen::Index i = 0; i < x.rows(); ++i)
      x.row(i) = reordered.row(position[i]).template cast<double>();
    return x;
  }

private:
  bool factorize(const SymmetricMatrix& A);
  void solve_in_place(Columns& x) const;
  void solve_column(Scalar* column) const;

  std::shared_ptr<const EliminationPlan> plan_;
  std::vector<Scalar> panels_; ///< L, unit lower triangles on top
  Vector pivots_;
  bool regular_ = false;
};

using SparseCholesky = SupernodalCholesky<double>;

extern template class SupernodalCholesky<double>;
extern template class SupernodalCholesky<float>;

}
