#pragma once
// Rates of strain along the surface in an orthonormal frame of the tangent plane.

#include "solver/surface/SurfaceIntegrals.h"

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
  /// What the velocity of a node whose function has the derivatives du and dv adds to the rate of strain e,
  /// as the factors of its components.
  struct Strain
  {
    Eigen::RowVector3d elongation; ///< e_tt − e_ss
    Eigen::RowVector3d shear;      ///< 2 e_ts
    Eigen::RowVector3d dilation;   ///< e_tt + e_ss
  };
  Strain strain(double du, double dv) const
  {
    const double along = du / length_, across = (dv * length_ - du * skew_) / J_;
    return { along * t - across * s, across * t + along * s, along * t + across * s };
  }

private:
  double length_, J_, skew_;
};

}
