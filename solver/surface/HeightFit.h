#pragma once
// A surface near one of its points as a height over the tangent plane: a polynomial through the
// point, fitted to others around it.

#include "solver/linear/SmallLeastSquares.h"
#include "solver/surface/MongePatch.h"

#include <span>
#include <vector>

namespace vesicle
{

/// Points around a vertex.
struct Patch
{
  Points offset;              ///< from the vertex
  std::vector<double> weight; ///< square roots of the weights: factors of the rows
  double size = 0;            ///< of the neighbourhood, > 0: coordinates are scaled by it

  int count() const { return static_cast<int>(weight.size()); }
};

/// z(x, y) = Σ c_ab x^a y^b, 1 ≤ a + b ≤ degree, weighted least squares. Keeps its memory from one
/// fit to the next.
class HeightFit
{
public:
  /// Degree 4, 3, 2, or 1, which stands for the second-order terms alone, the tangent plane being
  /// the normal's. False where the points don't determine all the terms (those of degree 1 are then
  /// the smallest possible).
  bool compute(const Patch& patch, const Vector3& normal, int degree);
  static int unknowns(int degree);

  // After compute() was true:

  const MongePatch& surface() const { return surface_; } ///< at the vertex
  /// Weighted root mean square distance of the points from the polynomial.
  double residual() const { return residual_; }
  /// The l of Δ_s f = Σ l_k (f_k − f), for a field given at the points of the same patch and at the
  /// vertex, to which a polynomial is fitted likewise. Valid until the next call of a member that
  /// isn't const.
  std::span<const double> laplacian(const Patch& patch);
  /// Standard error of H if what the fit leaves over is noise, as large at every point and at the
  /// vertex and independent. To a change of the heights H answers as −½ of what `laplacian` says,
  /// where the slopes are small.
  double mean_error(std::span<const double> laplacian) const;

private:
  bool determine(const Patch& patch, int degree);
  bool determine_second_order(const Patch& patch);
  void describe(const Patch& patch, const Vector3& second_order, double residual,
    std::span<const double> leverage);

  int degree_ = 0;
  double size_ = 0;
  std::vector<double> x_, y_, z_; ///< of the points in the frame, in sizes
  MongePatch surface_;
  double residual_ = 0, noise_ = 0;
  SmallLeastSquares equations_;
  Eigen::MatrixXd second_order_; ///< degree 1: values at the points → coefficients
  std::vector<double> functional_, laplacian_;
};

}
