#pragma once
// Curvature at the quadrature points of a basis with second derivatives, and integrals of products
// of its functions.

#include "solver/surface/ElementPattern.h"
#include "solver/surface/SurfaceIntegrals.h"

namespace vesicle
{

/// Curvature at the quadrature points of a table, and Δ_s N_k of its entries.
struct PointCurvature
{
  Eigen::VectorXd mean, gauss; ///< of every point; H = +1/R on a sphere
  std::vector<double> laplacian; ///< Δ_s N_k = a^{αβ}(∂_α∂_β N_k − Γ^γ_{αβ} ∂_γ N_k) of every entry
};
PointCurvature point_curvature(
  const BasisTable& table, const SurfacePoints& surface, const Points& control);

/// Σ_points dS a_j a_k, N by N, for a number a_k = value(point, entry) of every entry.
template<class Value>
SparseMatrix gram_matrix(const BasisTable& table, const SurfacePoints& surface, Value value);

/// 2 Σ_q R_qᵀR_q, 3N by 3N, over the rows of a table and all R; of each R the three numbers of every
/// entry.
SparseMatrix gauss_newton_matrix(const BasisTable& table, const std::vector<EntryVectors>& rates);
/// M_jk = ∮ N_j N_k dS.
SparseMatrix mass_matrix(const BasisTable& table, const SurfacePoints& surface);
/// L_jk = ∮ ∇N_j·∇N_k dS.
SparseMatrix stiffness_matrix(const BasisTable& table, const SurfacePoints& surface);
/// ∮ Δ_s N_j Δ_s N_k dS: N by N.
SparseMatrix bilaplacian(
  const BasisTable& table, const SurfacePoints& surface, const PointCurvature& curvature);
/// ∮ (2H − c0) [Δ_s N_k + (2H² − 2K + c0 H) N_k] dS: N, the weak form of 2 Δ_s H +
/// (2H − c0)(2H² − 2K + c0 H), which is the first variation of ½ ∮ (2H − c0)² dS under −N_k n. No
/// derivative beyond the second is needed.
Eigen::VectorXd bending_moments(const BasisTable& table, const SurfacePoints& surface,
  const PointCurvature& curvature, double c0 = 0);
/// Δ_s H from the values of 2 Δ_s H + 4 H (H² − K), H and K.
Eigen::VectorXd laplacian_of_mean(
  const Eigen::VectorXd& force, const Eigen::VectorXd& mean, const Eigen::VectorXd& gauss);
/// ∮ f N_k dS for f given at the quadrature points: N.
Eigen::VectorXd moments(
  const BasisTable& table, const SurfacePoints& surface, const Eigen::VectorXd& f);
/// The same of a part of the surface's points, added to what is there.
void add_bending_moments(const BasisTable& table, const SurfacePoints& surface,
  const PointCurvature& curvature, double c0, Eigen::Ref<Eigen::VectorXd> to);
void add_moments(const BasisTable& table, const SurfacePoints& surface, const Eigen::VectorXd& f,
  Eigen::Ref<Eigen::VectorXd> to);

template<class Value>
SparseMatrix gram_matrix(const BasisTable& table, const SurfacePoints& surface, Value value)
{
  return element_sum<1, 1>(table,
    [&](ElementSum<1, 1>& sum, int q, int first, int width)
    {
      thread_local std::vector<double> a;
      a.resize(width);
      for (int k = 0; k < width; ++k)
        a[k] = value(q, first + k);
      sum.add_outer_product(surface.area_weight[q], a.data(), a.data());
    });
}

}
