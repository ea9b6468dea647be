#pragma once
// Derivatives along the surface in an orthonormal frame of the tangent plane.

#include "solver/surface/SurfaceIntegrals.h"

#include <utility>

namespace vesicle
{

/// At a row of a surface's points.
struct TangentFrame
{
  Eigen::RowVector3d t, s; ///< unit, t along ∂x/∂u

  TangentFrame(const SurfacePoints& surface, int row)
  {
    const Eigen::RowVector3d a = surface.tangent_u.row(row), b = surface.tangent_v.row(row),
                             cross = surface.cross.row(row);
    length_ = a.norm();
    J_ = cross.norm();
    skew_ = a.dot(b) / length_;
    t = a / length_;
    s = cross.cross(t) / J_;
  }
  /// Along t and s, of a function with the derivatives du and dv.
  std::pair<double, double> derivatives(double du, double dv) const
  {
    return { du / length_, (dv * length_ - du * skew_) / J_ };
  }

private:
  double length_, J_, skew_;
};

}
