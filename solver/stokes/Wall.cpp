#include "solver/stokes/Wall.h"

#include <cmath>

namespace vesicle
{

Eigen::VectorXd Wall::heights(const Points& x) const
{
  return (x.rowwise() - point.transpose()) * normal;
}

void rest_behind(const Wall& wall, const Points& points, Points& velocities)
{
  const Eigen::VectorXd height = wall.heights(points);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    if (height[i] < 0)
      velocities.row(i).setZero();
}

WallFrame::WallFrame(const Wall& wall) : point_(wall.point.transpose())
{
  const Vector3& n = wall.normal;
  constexpr double nearly_along = 0.9;
  const Vector3 start = std::abs(n.x()) < nearly_along ? Vector3::UnitX() : Vector3::UnitY(),
                first = (start - start.dot(n) * n).normalized();
  axes_ << first.transpose(), n.cross(first).transpose(), n.transpose();
  mirrored_axes_ = axes_;
  mirrored_axes_.row(2) *= -1;
}

Points WallFrame::positions(const Points& x) const
{
  return (x.rowwise() - point_) * axes_.transpose();
}

Points WallFrame::mirrored_positions(const Points& x) const
{
  return (x.rowwise() - point_) * mirrored_axes_.transpose();
}

Points WallFrame::mirrored_vectors(const Points& v) const
{
  return v * mirrored_axes_.transpose();
}

Points WallFrame::vectors_outside(const Points& v) const
{
  return v * axes_;
}

}
