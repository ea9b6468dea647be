#pragma once
// How curvature and area follow the control points of a smooth surface: exact first derivatives of
// what the quadrature sees.

#include "solver/surface/SurfaceIntegrals.h"

namespace vesicle
{

/// At the rows of a table. A displacement δx of the control points of an entry's node changes 2H of
/// the row by of_twice_mean·δx and its area weight by the fraction of_area·δx: with N_k of the entry,
///   δ(2H) = −Δ_s N_k n·δx + 2 b^{αβ} ∂_β N_k a_α·δx,   δ(dS)/dS = ∂_α N_k a^α·δx.
/// (a_α tangents, a^α their dual, b the second fundamental form with n outward: b_{αβ} = ∂_α∂_β x·n.)
struct CurvatureRates
{
  Eigen::VectorXd twice_mean;          ///< 2H of every row
  EntryVectors of_twice_mean, of_area; ///< of every entry
};
CurvatureRates curvature_rates(
  const BasisTable& table, const SurfacePoints& surface, const Points& control);

/// ∂/∂c of ∮ H dS: 3N.
Eigen::VectorXd integrated_mean_curvature_gradient(
  const BasisTable& table, const SurfacePoints& surface, const Points& control);

}
