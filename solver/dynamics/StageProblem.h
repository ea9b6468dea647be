#pragma once
// The linear problem of one stage of a time step: at a frozen shape, find the velocity, the tension
// and the bending force after a time τ, implicitly, paper (36)–(41) in the form reduced to two
// unknowns a node.
//
//   u = u∞ + u_load + S_n (φ + ψ) + S_γ γ + c n   at the vertices
//   ċ = P⁻¹ u                                     at the control points (P = I for linear elements)
//   M ψ = τ R P⁻¹(u − U − reference)              U the velocity of the volume's centroid
//   D ċ = 0,  ∇V·u = 0
//
// ψ is the change of the bending density φ by the motion, γ the tension, c the multiplier of the
// volume row: a small uniform normal velocity, as a force for it would be singular (a pressure
// moves nothing). The unknowns are [ψ; γ; c; s]; ψ, γ or c are absent where the scene or the scheme
// doesn't have them, s is the slack of a pinned gauge (see ShapeOperators).

#include "solver/dynamics/DenseFactorization.h"
#include "solver/dynamics/Discretization.h"

namespace vesicle
{

struct StageSolution
{
  Eigen::VectorXd velocity; ///< 3N
  Eigen::VectorXd bending;  ///< φ + ψ: N or empty
  Eigen::VectorXd tension;  ///< γ: N or empty
  double volume_speed = 0;  ///< c
  int iterations = 0;
};

class StageProblem
{
public:
  /// All arguments must outlive the problem. `response` is that of `shape`. `tau`: implicit time;
  /// 0: bending is that of the shape, and ψ is absent.
  StageProblem(const Model& model, const Discretization& discretization,
    const ShapeOperators& shape, const VelocityResponse& response, double tau);

  int unknowns() const { return total_; }

  /// Solves by GMRES to `tolerance`, preconditioned by the factorisation of this or a nearby
  /// problem of the same size. `reference` (3N or empty) is the velocity relative to the centroid's
  /// that the implicit response is measured from. Throws NumericalError if it doesn't converge in
  /// `max_iterations` or isn't finite.
  StageSolution solve(const DenseFactorization& preconditioner, double tolerance,
    int max_iterations, const Eigen::VectorXd& reference) const;

  /// The problem's dense matrix, for the preconditioner.
  DenseFactorization::Matrix dense() const;

  /// u − U at every node.
  static Eigen::VectorXd relative_to_centroid(
    const ShapeOperators& shape, const Eigen::VectorXd& velocity);

private:
  Eigen::VectorXd velocity_of(const Eigen::VectorXd& unknowns) const;
  Eigen::VectorXd part(const Eigen::VectorXd& unknowns, int first) const;
  Eigen::VectorXd apply(const Eigen::VectorXd& unknowns) const;
  Eigen::VectorXd known_velocity() const;
  Eigen::VectorXd slack_column() const;

  const Model& model_;
  const Discretization& discretization_;
  const ShapeOperators& shape_;
  const VelocityResponse& response_;
  double tau_;
  int nodes_;
  int bending_, tension_, volume_, slack_, total_; ///< first index of each unknown, −1 if absent
};

}
