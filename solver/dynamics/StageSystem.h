#pragma once
// The linear problem of one stage of a time step on flat triangles: at a frozen shape, find the
// velocity, the tension and the stiff forces after a time τ, implicitly, paper (36)–(41) in the form
// reduced to two unknowns a node.

// clang-format off
//
//   u = u∞ + S (φ + other forces) + S_n ψ + S_γ γ + c n
//
//   ψ = τ R (u − U − reference)                                 stiff_block
//   D u = 0                                                     tension_block
//   ∇V·u = 0                                                    volume_block
//
// clang-format on

// The unknowns are the blocks [ψ; γ; c] of each vesicle; those that the system doesn't have aren't
// there.

#include "solver/dynamics/StageBlock.h"
#include "solver/dynamics/StageSolution.h"

namespace vesicle
{

class Preconditioner;

class StageSystem
{
public:
  /// All arguments must outlive the system. `mobility` is that of `shape`. `tau`: implicit time; 0:
  /// stiff forces are those of the shape, and ψ is absent. `reference` (of all vertices, or empty)
  /// is the velocity relative to the centroids' that the implicit response is measured from.
  StageSystem(const SystemShape& shape, const std::vector<Mobility>& mobility, double tau,
    const Eigen::VectorXd& reference);

  Eigen::Index unknowns() const { return first_.back(); }
  const std::vector<StageBlock>& blocks() const { return blocks_; }

  Eigen::VectorXd apply(const Eigen::VectorXd& unknowns) const;
  Eigen::VectorXd right_side() const;
  Eigen::MatrixXf dense() const;

  /// Solves by GMRES to the relative residual `tolerance`, with a preconditioner made for this or a
  /// nearby system of the same size. Throws NumericalError if it doesn't converge in
  /// `max_iterations` or isn't finite.
  StageSolution solve(
    const Preconditioner& preconditioner, double tolerance, int max_iterations) const;

private:
  void add_vesicle(
    std::size_t vesicle, const Mobility& mobility, double tau, const Eigen::VectorXd& reference);
  void add(StageBlock block);
  Eigen::VectorXd velocity_of(const Eigen::VectorXd& unknowns) const;
  Eigen::VectorXd rows_of(const Eigen::VectorXd& velocity) const;
  StageSolution solution_of(const Eigen::VectorXd& unknowns) const;

  const SystemShape& shape_;
  std::vector<StageBlock> blocks_;
  std::vector<Eigen::Index> first_{ 0 }; ///< first unknown of each block, and the number of all
  Eigen::VectorXd known_;                ///< velocity without the unknowns
  struct Blocks
  {
    int stiff = -1, tension = -1, volume = -1; ///< −1: absent
  };
  std::vector<Blocks> of_vesicle_;
};

}
