#pragma once
// A surface around a vertex at a length scale above that of its noise: the second-order height that
// is nearest to all points within a radius, the vertex being one of them.

#include "solver/surface/MongePatch.h"

#include <span>
#include <vector>

namespace vesicle
{

/// Points and unit normals.
struct Candidates
{
  std::vector<double> x, y, z, nx, ny, nz;
};

/// Fits z = c0 + c1 x + c2 y + c3 x² + c4 xy + c5 y² to points of equal weights, twice: over the
/// plane of the normal given, then over the tangent plane found, from the foot of the vertex, with
/// heights z (1 − |∇z|²/4) in the place of z. Those are quadratic to fourth order where the normal
/// sections in the principal directions are circles and x²y² has the mean of what it has on the two
/// surfaces of revolution of these circles; so spheres and cylinders come out right up to radii of
/// more than half of their own, and H of tori and saddles nearly so.
///
/// Equal weights and free c0: of unbiased fits that with the least noise (Gauss–Markov). Of
/// measured alternatives (smooth weights, weights by area, fourth order, sections as circles in all
/// directions) none was nearer to the truth on segmented images; docs/filters.md says how near it
/// is.
class ScaleFit
{
public:
  /// Takes those candidates that are no farther from the vertex than `radius` and face as the unit
  /// vector `normal` does, up to a least cosine. Returns how many.
  int choose(const Candidates& from, const Vector3& vertex, const Vector3& normal, double radius,
    double least_cosine);
  /// Their numbers among the candidates.
  const std::vector<int>& chosen() const { return chosen_; }
  int count() const { return static_cast<int>(x_.size()); }

  /// False where the points don't determine the terms. `normal`: a unit vector near the surface's.
  bool compute(const Vector3& normal, double radius);

  // After compute() was true:

  const MongePatch& surface() const { return surface_; } ///< at the foot of the vertex
  /// Root mean square distance of the points from the fit.
  double residual() const { return residual_; }
  /// Standard error of H if what the fit leaves over is noise, independent from point to point.
  double mean_error() const { return mean_error_; }

  /// Δ_s f at the vertex by the same fit to a field given at the points, over the plane of the
  /// surface's normal; compute() isn't needed for it. 0 where the points don't determine it.
  double laplacian(const Vector3& normal, double radius, std::span<const double> field);

private:
  void see_from(const Eigen::Matrix3d& frame, const Vector3& origin, double radius);
  bool fit(std::span<const double> heights);

  std::vector<int> chosen_;
  std::vector<double> x_, y_, z_; ///< of the points, from the vertex
  std::vector<double> u_, v_, w_; ///< in a frame, in radii
  Eigen::Vector<double, 6> coefficients_;
  double misfit_ = 0;        ///< mean square
  double mean_variance_ = 0; ///< of −(c3 + c5) for heights of variance 1
  MongePatch surface_;
  double residual_ = 0, mean_error_ = 0;
};

}
