#pragma once
// Curvatures of surfaces given by a formula, for errors at any point of any mesh.

#include "solver/surface/Cotan.h"

#include <functional>

namespace vesicle
{

/// n outward, H = +1/R on a sphere.
struct ExactCurvature
{
  Vector3 normal;
  double mean, gauss, laplacian_mean; ///< H, K, Δ_s H
  /// Bending force density along n, EB = 1.
  double density() const { return 2 * laplacian_mean + 4 * mean * (mean * mean - gauss); }
};

/// A surface F = 0, F growing outwards.
struct LevelSet
{
  std::function<Vector3(const Vector3&)> gradient;
  std::function<Eigen::Matrix3d(const Vector3&)> hessian;
};

/// H and K by their formulas, Δ_s H = Δh − 2H ∂_n h − ∂_n² h from the H = h(x) of all level sets
/// around, by differences of sixth order: right to 1e-6 on the surfaces below.
ExactCurvature exact_curvature(const LevelSet& surface, const Vector3& point);

/// (2 n_x, n_y, n_z).
const LevelSet& ellipsoid_2_1_1_level_set();
/// r = 1 + 0.61 n_x + 0.4 n_x² n_y.
const LevelSet& paper_surface_level_set();

}
