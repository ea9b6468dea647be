#pragma once
// A preconditioner for the stages of smooth surfaces with no part of the single layer in it: a local
// operator with the layer's symbol on a plane, 1/(4k), in its place, and the vertices for the
// control points. The number of iterations doesn't grow with the mesh.

#include "solver/dynamics/VesicleLoads.h"

namespace vesicle
{

struct LoadUnknowns;

/// Of one vesicle. A_i = (2/k₀)(L + k₀² M) with L = ∮ ∇N_j·∇N_k dS, M the mass matrix and
/// k₀ = 2 N^¼/R, R = √(A/4π), stands for the inverse of the single layer;
/// between two fluids times (1 + λ)/2, as all but the rigid motions feel the mean of the viscosities.
class LocalPreconditioner
{
public:
  /// The tension's part, [A_i ⊗ 1₃, Bᵀ; B, F]: depends on the shape alone and stays good for shapes
  /// nearby.
  void build(const VesicleLoads& loads);
  bool built() const { return nodes_ > 0; }
  /// The part of ν, A_i + τ EᵀKE + T at the control points: for this shape and τ, where there is one.
  void build_stiff(const VesicleLoads& loads, double tau);

  LoadUnknowns solve(const VesicleLoads& loads, const LoadUnknowns& residual) const;

private:
  Eigen::VectorXd parameters(const VesicleLoads& loads, const LoadUnknowns& residual) const;
  /// Tension, pressure and c of x.
  void solve_saddle(const LoadUnknowns& residual, LoadUnknowns& x) const;
  /// The volume's, c's and the gauge's row, of (w, γ).
  Eigen::VectorXd border_rows(const Eigen::VectorXd& w_and_tension) const;

  Eigen::Index nodes_ = 0;
  SparseMatrix layer_inverse_; ///< A_i of the stiff terms' part
  SupernodalCholesky<float> saddle_, stiff_;
  /// What p, c and, of a taut sphere, the slack of the total area add to (w, γ): columns.
  Eigen::MatrixXd columns_;
  Eigen::MatrixXd border_; ///< the rows that belong to them, of the columns
  Eigen::VectorXd vertex_area_;
  Eigen::VectorXd volume_rate_, pushed_normal_; ///< Qᵀv and A_i n̂
  bool has_tension_ = false, taut_ = false;
};

}
