#pragma once
// How curvature and area follow the control points of a smooth surface: exact first derivatives of
// what the quadrature sees.

#include "solver/surface/SurfaceIntegrals.h"

#include <array>
#include <vector>

namespace vesicle
{

/// At the rows of a table. A displacement δx of the surface changes 2H of a row and its area weight by
///   δ(2H) = −Δ_s δx·n + 2 b^{αβ} ∂_β δx·a_α,   δ(dS)/dS = ∂_α δx·a^α
/// (a_α tangents, a^α their dual, b the second fundamental form with n outward: b_{αβ} = ∂_α∂_β x·n):
/// the gradients with respect to x's derivatives ∂_u, ∂_v and, of 2H, ∂_u², ∂_u∂_v, ∂_v², in columns.
struct CurvatureRates
{
  using Gradient = Eigen::Matrix<double, 3, 5>;
  Eigen::VectorXd twice_mean; ///< 2H of every row
  std::vector<Gradient> of_twice_mean;
  std::vector<Eigen::Matrix<double, 3, 2>> of_area;
};
CurvatureRates curvature_rates(
  const BasisTable& table, const SurfacePoints& surface, const Points& control);
/// The entries' numbers that belong to the columns, for nodal_gradient and entry_gradients.
std::array<const double*, 5> curvature_fields(const BasisTable& table);

/// ∂/∂c of ∮ H dS: 3N.
Eigen::VectorXd integrated_mean_curvature_gradient(
  const BasisTable& table, const SurfacePoints& surface, const Points& control);

}
