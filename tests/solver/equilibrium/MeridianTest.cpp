#include "solver/equilibrium/Meridian.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vesicle
{
namespace
{

using std::numbers::pi;

Meridian spheroid(int intervals, double a, double c)
{
  return Meridian(intervals,
    [=](double t) -> Eigen::Vector2d {
      return { a * std::sin(t), c * std::cos(t) };
    });
}

TEST(Meridian, SphereHasItsMeasures)
{
  const Meridian sphere = spheroid(60, 1, 1);
  const Meridian::Measures m = sphere.measures();
  EXPECT_NEAR(m.energy, 8 * pi, 1e-5);
  EXPECT_NEAR(m.area, 4 * pi, 1e-7);
  EXPECT_NEAR(m.volume, 4 * pi / 3, 1e-7);
  for (const double t : { 0., 0.3, 1.5, 3., pi })
  {
    const auto [along, across] = sphere.at(t).curvatures();
    EXPECT_NEAR(along, 1, 1e-3) << t;
    EXPECT_NEAR(across, 1, 1e-3) << t;
  }
}

TEST(Meridian, SpheroidHasItsMeasures)
{
  const double a = 0.8, c = 1.5, e = std::sqrt(1 - a * a / (c * c));
  const Meridian::Measures m = spheroid(60, a, c).measures();
  EXPECT_NEAR(m.area, 2 * pi * a * a * (1 + c / (a * e) * std::asin(e)), 1e-7);
  EXPECT_NEAR(m.volume, 4 * pi / 3 * a * a * c, 1e-7);
}

// The parametrisation is the solver's to choose: at the constructor's it costs nothing.
TEST(Meridian, SpeedIsEvenFromTheStart)
{
  EXPECT_LT(spheroid(60, 0.8, 1.5).measures().unevenness, 1e-3);
}

TEST(Meridian, DerivativesAreThoseOfTheMeasures)
{
  Meridian m = spheroid(20, 0.9, 1.3);
  const Eigen::Index n = m.coefficients().size();
  Eigen::VectorXd direction(n);
  for (Eigen::Index i = 0; i < n; ++i)
    direction[i] = std::sin(1 + 0.7 * static_cast<double>(i));
  const auto at = [&](double h)
  {
    Meridian moved = m;
    moved.move(h * direction);
    return moved;
  };
  const double h = 1e-6;
  const Meridian::Derivatives d = m.derivatives();
  const Meridian::Measures ahead = at(h).measures(), behind = at(-h).measures();
  EXPECT_NEAR(d.energy.dot(direction) / ((ahead.energy - behind.energy) / (2 * h)), 1, 1e-6);
  EXPECT_NEAR(d.area.dot(direction) / ((ahead.area - behind.area) / (2 * h)), 1, 1e-6);
  EXPECT_NEAR(d.volume.dot(direction) / ((ahead.volume - behind.volume) / (2 * h)), 1, 1e-6);
  EXPECT_NEAR(
    d.unevenness.dot(direction) / ((ahead.unevenness - behind.unevenness) / (2 * h)), 1, 1e-5);

  const double tension = -3, pressure = 2;
  const auto gradient = [&](const Meridian& at) -> Eigen::VectorXd
  {
    const Meridian::Derivatives g = at.derivatives();
    return g.energy + tension * g.area - pressure * g.volume + g.unevenness;
  };
  const Eigen::VectorXd change = (gradient(at(h)) - gradient(at(-h))) / (2 * h),
                        second = m.second_derivatives(tension, pressure) * direction;
  EXPECT_LT((change - second).norm(), 1e-6 * second.norm());
}

}
}
