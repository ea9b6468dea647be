#pragma once
// Functionals of a smooth surface's curvature, ∮ φ(2H) dS − p V, with the exact first and second
// derivatives of what the quadrature sees.

#include "solver/surface/NodeFrames.h"
#include "solver/surface/SurfaceIntegrals.h"

namespace vesicle
{

/// φ, φ′ and φ″ at the rows of a table: of the area 1, 0, 0; of bending ½ (2H − c0)², 2H − c0, 1.
struct CurvatureDensity
{
  Eigen::VectorXd value, slope, curvature;

  explicit CurvatureDensity(Eigen::Index rows)
    : value(Eigen::VectorXd::Zero(rows)), slope(value), curvature(value)
  {
  }
};

/// A surface with what its functionals need: its points and their second derivatives.
struct CurvedPoints
{
  CurvedPoints(const BasisTable& table, const Points& control);

  SurfacePoints points;
  SecondDerivatives second;
  Eigen::VectorXd twice_mean; ///< 2H
};

/// ∂/∂c of ∮ φ(2H) dS: 3N.
Eigen::VectorXd curvature_gradient(
  const BasisTable& table, const CurvedPoints& surface, const CurvatureDensity& density);

/// The second derivative; its pattern is a table's and made once.
///
/// With a, b the tangents, m = a × b, Q = m·m and P = b² ∂²x/∂u²·m − 2 a·b ∂²x/∂u∂v·m + a² ∂²x/∂v²·m,
/// 2H = −P Q^{−3/2} and dS = √Q du dv: polynomials of x and its derivatives, which are linear in the
/// control points.
class SecondVariation
{
public:
  explicit SecondVariation(const BasisTable& table);

  /// ∂²/∂c² of ∮ φ(2H) dS − p V in the nodes' frames: 3N by 3N, its lower triangle.
  Eigen::SparseMatrix<double> matrix(const CurvedPoints& surface, const CurvatureDensity& density,
    double pressure, const NodeFrames& frames) const;

private:
  const BasisTable& table_;
  Eigen::SparseMatrix<double> pattern_;
  std::vector<int>
    block_; ///< of each pair of an element's nodes: its place in its column of blocks
};

}
