#pragma once
// A preconditioner for the stages of smooth surfaces with no part of the single layer in it: a local
// operator with the layer's symbol on a plane, 1/(4k), in its place, and the vertices for the
// control points. The number of iterations doesn't grow with the mesh.

#include "solver/dynamics/VesicleLoads.h"

namespace vesicle
{

struct LoadUnknowns;

/// A_i, see LocalPreconditioner: N by N.
SparseMatrix layer_inverse(const VesicleLoads& loads);

/// Of one vesicle. A_i = (2/k₀)(L + k₀² M) with L = ∮ ∇N_j·∇N_k dS, M the mass matrix and
/// k₀ = 2 N^¼/R, R = √(A/4π), stands for the inverse of the single layer;
/// between two fluids times (1 + λ)/2, as all but the rigid motions feel the mean of the viscosities.
///
/// The viscosity V of a membrane and its tension act on the same velocities along it. There ν and the
/// tension are solved for together, with [A_i ⊗ 1₃ + τ K + V + T, Bᵀ; B, F].
class LocalPreconditioner
{
public:
  /// The tension's part, [A_i ⊗ 1₃ (+ V), Bᵀ; B, F]: depends on the shape alone and stays good for
  /// shapes nearby.
  void build(const VesicleLoads& loads);
  bool built() const { return nodes_ > 0; }
  /// The part of ν, A_i + τ EᵀKE + T at the control points: for this shape and τ, where there is one.
  void build_stiff(const VesicleLoads& loads, double tau);

  LoadUnknowns solve(const VesicleLoads& loads, const LoadUnknowns& residual) const;

private:
  /// `tau`: of a viscous membrane's stiff terms.
  void build_saddle(const VesicleLoads& loads, double tau);
  Eigen::VectorXd parameters(const VesicleLoads& loads, const LoadUnknowns& residual) const;
  /// Tension, pressure and c of x; of a viscous membrane ν too.
  void solve_saddle(const VesicleLoads& loads, const LoadUnknowns& residual, LoadUnknowns& x) const;
  /// The volume's, c's and the gauge's row, of (w, γ).
  Eigen::VectorXd border_rows(const Eigen::VectorXd& w_and_tension) const;

  Eigen::Index nodes_ = 0;
  SparseMatrix layer_inverse_; ///< A_i of ν's part
  SupernodalCholesky<float> saddle_, stiff_;
  /// What p, c and, of a taut sphere, the slack of the total area add to (w, γ): columns.
  Eigen::MatrixXd columns_;
  Eigen::MatrixXd border_; ///< the rows that belong to them, of the columns
  Eigen::VectorXd vertex_area_;
  Eigen::VectorXd volume_rate_, pushed_normal_; ///< Qᵀv and A_i n̂
  bool has_tension_ = false, taut_ = false;
};

}
