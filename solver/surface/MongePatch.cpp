#include "solver/surface/MongePatch.h"

#include <Eigen/LU>

#include <cmath>

namespace vesicle
{

namespace
{

/// g the determinant of the metric, g^{ab} its inverse.
struct Metric
{
  explicit Metric(const MongePatch& patch)
    : zx(patch.slope[0]), zy(patch.slope[1]), g(1 + zx * zx + zy * zy), xx((1 + zy * zy) / g),
      xy(-zx * zy / g), yy((1 + zx * zx) / g)
  {
  }
  /// g^{ab} z_ab
  double trace(const MongePatch& patch) const
  {
    return xx * patch.slope[2] + 2 * xy * patch.slope[3] + yy * patch.slope[4];
  }

  double zx, zy, g, xx, xy, yy;
};

}

Eigen::Matrix3d frame_along(const Vector3& normal)
{
  Eigen::Matrix3d frame;
  const Vector3 x = normal.unitOrthogonal();
  frame << x.transpose(), normal.cross(x).transpose(), normal.transpose();
  return frame;
}

Vector3 MongePatch::normal() const
{
  return frame.transpose() * Vector3(-slope[0], -slope[1], 1).normalized();
}

// H = −½ g^{ab} z_ab/√g
double MongePatch::mean() const
{
  const Metric metric(*this);
  return -0.5 * metric.trace(*this) / std::sqrt(metric.g);
}

// K = det z_ab/g²
double MongePatch::gauss() const
{
  const double g = Metric(*this).g;
  return (slope[2] * slope[4] - slope[3] * slope[3]) / (g * g);
}

// The normal curvature along the tangent T a, T of columns x + z_x z and y + z_y z, is aᵀ B a over
// its squared length aᵀ TᵀT a, B = −z_ab/√g; T⁺ leads from tangents to their a.
Eigen::Matrix3d MongePatch::shape() const
{
  Eigen::Matrix<double, 3, 2> T;
  T << 1, 0, 0, 1, slope[0], slope[1];
  Eigen::Matrix2d B;
  B << slope[2], slope[3], slope[3], slope[4];
  B /= -std::sqrt(Metric(*this).g);
  const Eigen::Matrix<double, 2, 3> inverse = (T.transpose() * T).inverse() * T.transpose() * frame;
  return inverse.transpose() * B * inverse;
}

Vector3 MongePatch::direction() const
{
  const Eigen::Matrix3d axes = frame_along(normal());
  const Eigen::Matrix2d S = (axes * shape() * axes.transpose()).topLeftCorner<2, 2>();
  const double angle = 0.5 * std::atan2(2 * S(0, 1), S(0, 0) - S(1, 1));
  const Vector3 tangent = axes.transpose() * Vector3(std::cos(angle), std::sin(angle), 0);
  Eigen::Index largest;
  tangent.cwiseAbs().maxCoeff(&largest);
  return tangent[largest] < 0 ? -tangent : tangent;
}

// Δ_s f = (1/√g) ∂_a(√g g^{ab} ∂_b f) = g^{ab} (f_ab − z_ab ∇z·∇f/g)
Eigen::Vector<double, 5> MongePatch::laplacian() const
{
  const Metric metric(*this);
  const double along = -metric.trace(*this) / metric.g;
  return { along * metric.zx, along * metric.zy, metric.xx, 2 * metric.xy, metric.yy };
}

}
