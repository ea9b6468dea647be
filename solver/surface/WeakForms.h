#pragma once
// Curvature at the quadrature points of a basis with second derivatives, and integrals of products
// of its functions.

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
/// ∮ f N_k dS for f given at the quadrature points: N.
Eigen::VectorXd moments(
  const BasisTable& table, const SurfacePoints& surface, const Eigen::VectorXd& f);

template<class Value>
SparseMatrix gram_matrix(const BasisTable& table, const SurfacePoints& surface, Value value)
{
  std::vector<Eigen::Triplet<double>> entries;
  for_each_element(table,
    [&](int begin, int end, std::span<const int> nodes)
    {
      const auto width = static_cast<Eigen::Index>(nodes.size());
      Eigen::MatrixXd local = Eigen::MatrixXd::Zero(width, width);
      Eigen::VectorXd a(width);
      for (int q = begin; q < end; ++q)
      {
        for (Eigen::Index k = 0; k < width; ++k)
          a[k] = value(q, table.start[q] + static_cast<int>(k));
        local.noalias() += surface.area_weight[q] * a * a.transpose();
      }
      for (Eigen::Index j = 0; j < width; ++j)
        for (Eigen::Index k = 0; k < width; ++k)
          entries.emplace_back(nodes[j], nodes[k], local(j, k));
    });
  SparseMatrix gram(table.nodes, table.nodes);
  gram.setFromTriplets(entries.begin(), entries.end());
  return gram;
}

}
