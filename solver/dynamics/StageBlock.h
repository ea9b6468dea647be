#pragma once
// On flat triangles a block of unknowns of a stage's linear problem, and the rows that belong to
// them. It says what it is once; the operator, the right-hand side and the dense matrix are all made from that
// (StageSystem.h).

#include "solver/dynamics/SystemShape.h"

namespace vesicle
{

/// Linear rows on one vesicle's velocities u at its vertices (3N): L u = direct u +
/// weight (functional u). Parts that aren't there are empty.
struct VelocityRows
{
  SparseMatrix direct;        ///< n by 3N
  Eigen::MatrixXd weight;     ///< n by k
  Eigen::MatrixXd functional; ///< k by 3N
};

/// Unknowns y of one vesicle with rows  L u + K y = prescribed,  where the velocity that these
/// unknowns make is u = X y: the columns of a mobility at all vertices, or one velocity of the
/// vesicle's own.
struct StageBlock
{
  std::size_t vesicle = 0;
  Eigen::Index size = 0; ///< n

  // X. The first unknowns have the columns [first, first + count) of `columns`, or the first has
  // `velocity`; what is left over makes none.
  const DenseMatrix* columns = nullptr;
  Eigen::Index first = 0, count = 0;
  Eigen::VectorXd velocity; ///< 3N of the vesicle, or empty

  VelocityRows rows;
  SparseMatrix own;           ///< K: n by n, or empty
  Eigen::VectorXd prescribed; ///< n, or empty: zero
};

/// ψ, the change of the stiff force density φ within a time `tau`: ψ = τ R (u − U −
/// reference), U the velocity of the volume's centroid, `reference` (3N or empty) a velocity
/// relative to it.
StageBlock stiff_block(const VesicleShape& shape, std::size_t vesicle, const Mobility& mobility,
  double tau, const Eigen::VectorXd& reference);

/// γ: D u = 0. Where the gauge is pinned one more unknown, the slack s of rows that would
/// be dependent, D (u + s n) = 0, and one more row, ∮ γ dS = 0.
StageBlock tension_block(const VesicleShape& shape, std::size_t vesicle, const Mobility& mobility);

/// c: ∇V·u = 0 by a small uniform normal velocity c n. A force for it would be singular: a pressure
/// moves nothing.
StageBlock volume_block(const VesicleShape& shape, std::size_t vesicle);

}
