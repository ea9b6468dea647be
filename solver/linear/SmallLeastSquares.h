#pragma once
// Least squares with a few unknowns, many of them one after the other.

#include <span>
#include <vector>

namespace vesicle
{

/// Least |A x − b| by modified Gram–Schmidt with column pivoting, b orthogonalised with the columns
/// of A, which is as stable as reflections (Å. Björck, BIT 7 (1967) 1). Keeps its memory from one
/// to the next; loops run down the columns, as wide as the processor's registers.
class SmallLeastSquares
{
public:
  /// The columns and the right side are then to be written.
  void resize(int rows, int unknowns);
  /// Of A, `rows` numbers each; they are overwritten by solve().
  double* column(int j) { return columns_.data() + static_cast<long>(j) * stride_; }
  double* right_side() { return column(unknowns_); }

  /// False where a column depends on the others: of columns scaled to unit length, what the chosen
  /// before leave of it is no longer than `threshold`. There is no solution then.
  bool solve(double threshold);
  std::span<const double> solution() const { return solution_; }
  /// |A x − b|.
  double residual() const { return residual_; }
  /// The w of wᵀb = gᵀx: how a functional of the solution, `unknowns` numbers, follows from the
  /// right side. Valid until the next call of a member that isn't const.
  std::span<const double> functional(std::span<const double> g);
  /// How much of each entry of b its own fitted value takes: the diagonal of A (AᵀA)⁻¹ Aᵀ, of sum
  /// `unknowns`. As functional().
  std::span<const double> leverages();

private:
  double& R(int k, int j) { return R_[static_cast<std::size_t>(k) * (unknowns_ + 2) + j]; }
  void substitute_back();

  int rows_ = 0, unknowns_ = 0;
  int stride_ = 0;                    ///< from a column to the next, with zeros behind the rows
  std::vector<double> columns_;       ///< A, b and zeros; then Q, what is left of b and zeros
  std::vector<int> order_;            ///< of the columns
  std::vector<double> length_, left_; ///< of A's columns
  std::vector<double> R_;             ///< a row a column chosen, numbered as in A
  std::vector<double> solution_, multipliers_, of_rows_;
  double residual_ = 0;
};

}
