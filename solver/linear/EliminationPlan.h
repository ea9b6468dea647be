#pragma once
// How a sparse symmetric matrix is eliminated, which its pattern alone decides.

#include <Eigen/SparseCore>

#include <vector>

namespace vesicle
{

using SymmetricMatrix = Eigen::SparseMatrix<double>; ///< by columns

/// The order of the columns that fills in least (approximate minimum degree) and their supernodes:
/// columns that follow each other and have the same rows below them, but for a few zeros that are
/// stored too. Each is a dense panel of its columns by columns and rows (Liu, SIAM Rev. 34 (1992) 82;
/// Ashcraft, Grimes, ACM Trans. Math. Softw. 15 (1989) 291).
class EliminationPlan
{
public:
  /// Of the lower triangle of A.
  explicit EliminationPlan(const SymmetricMatrix& A);

  struct Supernode
  {
    int first, columns;
    int parent = -1;         ///< the supernode of the first of the rows; −1: there is none
    std::vector<int> rows;   ///< below the columns, ascending
    std::vector<int> place;  ///< of each of them among the parent's columns and rows
    Eigen::Index offset = 0; ///< where the panel begins

    int height() const { return columns + static_cast<int>(rows.size()); }
  };
  /// Children before their parents.
  const std::vector<Supernode>& supernodes() const { return supernodes_; }
  /// The new place of each row and column.
  const std::vector<int>& position() const { return position_; }
  /// Of all panels.
  Eigen::Index panel_entries() const { return panel_entries_; }
  /// Of each of the matrix's entries: where in the panels it goes; −1: above the diagonal.
  const std::vector<Eigen::Index>& targets() const { return targets_; }

  int size() const { return static_cast<int>(position_.size()); }
  /// Whether A has the pattern that the plan was made for.
  bool fits(const SymmetricMatrix& A) const;

private:
  using Lists = std::vector<std::vector<int>>; ///< of each column

  void find_supernodes(const std::vector<int>& parent, const std::vector<int>& count);
  void find_rows(const Lists& below);
  void find_targets(const SymmetricMatrix& A);
  std::vector<int> owners() const; ///< each column's supernode

  std::vector<int> outer_, inner_; ///< the pattern
  std::vector<int> position_;
  std::vector<Supernode> supernodes_;
  std::vector<Eigen::Index> targets_;
  Eigen::Index panel_entries_ = 0;
};

}
