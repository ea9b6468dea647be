#pragma once
// Closed axisymmetric surfaces by their meridian, a spline curve (r(t), z(t)), t from 0 at the upper
// pole to π at the lower one, and what the membrane's energy makes of it.

#include <Eigen/Core>

#include <array>
#include <functional>

namespace vesicle
{

/// r is odd and z even about both poles, so that the surface is smooth there: quintic B-splines on
/// even knots, continued by reflection.
class Meridian
{
public:
  struct Point
  {
    double r, r1, r2, z, z1, z2; ///< with first and second derivatives in t

    double speed() const; ///< √(r′² + z′²)
    /// Principal curvatures: of the meridian, and across it; +1 on a unit sphere.
    std::array<double, 2> curvatures() const;
  };
  /// Points of a curve from pole to pole, t from 0 to π.
  using Curve = std::function<Eigen::Vector2d(double t)>;

  /// Through the curve's points at the knots, spread along it such that the speed is about in
  /// proportion to the distance to the axis: necks are resolved as well as the rest.
  Meridian(int intervals, const Curve& curve);

  Point at(double t) const;
  int intervals() const { return intervals_; }
  /// Coefficients: those of r but the first and the last, which are 0, then those of z.
  const Eigen::VectorXd& coefficients() const { return coefficients_; }
  void move(const Eigen::VectorXd& displacement) { coefficients_ += displacement; }
  void scale(double factor) { coefficients_ *= factor; }

  /// E = ½ ∮ (2H)² dS, area, volume and the unevenness U of the speed, a number ≥ 0 that is 0 where
  /// the speed is as the constructor has it and fixes the parametrisation that the rest leaves free.
  struct Measures
  {
    double energy = 0, area = 0, volume = 0, unevenness = 0;
  };
  struct Derivatives
  {
    Measures value;
    Eigen::VectorXd energy, area, volume, unevenness;
  };
  Measures measures() const;
  Derivatives derivatives() const;
  /// Of E + tension A − pressure V + U.
  Eigen::MatrixXd second_derivatives(double tension, double pressure) const;

private:
  double mean_speed() const;

  int intervals_;
  Eigen::VectorXd coefficients_;
};

}
