#pragma once
// What a surface given point by point over the unit sphere is like at one of its points, by central
// differences of its parametrisation.

#include "solver/mesh/shapes/SphericalParametrisation.h"

namespace vesicle
{

/// A surface above one direction d. Tangents are derivatives of the point along the columns of
/// `across`, two unit vectors normal to d and to each other.
struct SurfaceElement
{
  Vector3 point;
  Eigen::Matrix<double, 3, 2> across, tangents;
  Vector3 normal;     ///< unit, outward
  double stretch;     ///< area on the surface per solid angle
  double mean, gauss; ///< H (+1/R on a sphere) and K

  double curvature_squared() const { return 4 * mean * mean - 2 * gauss; } ///< κ1² + κ2²
};

/// Curvatures of the order of the surface's own are right to 1e-6.
SurfaceElement surface_element(const SphericalParametrisation& surface, const Vector3& direction);

}
