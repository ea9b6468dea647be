#pragma once
// Bending on a smooth surface given by a basis with second derivatives, in weak form. All with EB
// = 1.

#include "solver/surface/SurfaceIntegrals.h"

namespace vesicle
{

/// Curvature at the rows of a table, and Δ_s N_k of its entries.
struct RowCurvature
{
  Eigen::VectorXd mean, gauss; ///< of every row; H = +1/R on a sphere
  std::vector<double> laplacian; ///< Δ_s N_k = a^{αβ}(∂_α∂_β N_k − Γ^γ_{αβ} ∂_γ N_k) of every entry
};
RowCurvature row_curvature(
  const BasisTable& table, const SurfacePoints& surface, const Points& control);

/// E = 2 ∮ H² dS.
double bending_energy(const SurfacePoints& surface, const RowCurvature& curvature);

/// ∮ f_b·n N_k dS = ∮ [2 H Δ_s N_k + 4 H (H² − K) N_k] dS: N. The first variation of E under the
/// normal displacement −N_k n, in which no derivative beyond the second is needed.
Eigen::VectorXd bending_load(
  const BasisTable& table, const SurfacePoints& surface, const RowCurvature& curvature);

/// Gauss–Newton part of the second variation, ∮ d_j d_k dS with d_k = Δ_s N_k + (4H² − 2K) N_k
/// (= −2 δH under N_k n): N by N, symmetric, positive semidefinite.
SparseMatrix bending_hessian(
  const BasisTable& table, const SurfacePoints& surface, const RowCurvature& curvature);

/// ∮ Δ_s N_j Δ_s N_k dS: N by N.
SparseMatrix bilaplacian(
  const BasisTable& table, const SurfacePoints& surface, const RowCurvature& curvature);

/// M_jk = ∮ N_j N_k dS.
SparseMatrix mass_matrix(const BasisTable& table, const SurfacePoints& surface);
/// ∮ f N_k dS for f given at the rows: N.
Eigen::VectorXd moments(
  const BasisTable& table, const SurfacePoints& surface, const Eigen::VectorXd& f);

}
