#pragma once
// A plane wall at which the fluid sticks.

#include "solver/mesh/TriangleMesh.h"

namespace vesicle
{

struct Wall
{
  Vector3 point{ 0, 0, 0 };
  Vector3 normal{ 0, 0, 1 }; ///< unit, into the fluid

  /// Above the wall; below 0 behind it.
  double height(const Vector3& x) const { return normal.dot(x - point); }
  Eigen::VectorXd heights(const Points& x) const;
};

/// Makes the velocities at points behind the wall zero.
void rest_behind(const Wall& wall, const Points& points, Points& velocities);

/// Axes in which the wall is z = 0 and the fluid above it. For a wall like that already they are x, y, z.
class WallFrame
{
public:
  explicit WallFrame(const Wall& wall);

  /// In these axes; N by 3.
  Points positions(const Points& x) const;
  /// The same on the other side of the wall, z ↦ −z.
  Points mirrored_positions(const Points& x) const;
  Points mirrored_vectors(const Points& v) const;
  /// Of vectors in these axes what they are outside.
  Points vectors_outside(const Points& v) const;

private:
  Eigen::RowVector3d point_;
  Eigen::Matrix3d axes_, mirrored_axes_; ///< a row each
};

}
