#pragma once
// A surface at one of its points as a height over a plane.

#include "solver/mesh/TriangleMesh.h"

namespace vesicle
{

/// z(x, y) by its derivatives at the point. Signs: H is +1/R on a sphere whose z points outward.
struct MongePatch
{
  Eigen::Matrix3d frame = Eigen::Matrix3d::Identity(); ///< rows: the axes x, y, z
  /// z_x, z_y, z_xx, z_xy, z_yy
  Eigen::Vector<double, 5> slope = Eigen::Vector<double, 5>::Zero();

  Vector3 normal() const;
  double mean() const;  ///< H
  double gauss() const; ///< K
  /// Unit tangent along which the normal curvature is greatest, with its largest component
  /// positive; normal() × it is that of the least. Any tangent where they are equal.
  Vector3 direction() const;
  /// The shape operator as a symmetric matrix in space: κ1 t1 t1ᵀ + κ2 t2 t2ᵀ.
  Eigen::Matrix3d shape() const;
  /// The l of Δ_s f = l · (f_x, f_y, f_xx, f_xy, f_yy).
  Eigen::Vector<double, 5> laplacian() const;
};

/// Axes of which z is the unit vector `normal`.
Eigen::Matrix3d frame_along(const Vector3& normal);

}
