#include "solver/surface/ExactCurvature.h"

#include <array>
#include <cmath>

namespace vesicle
{

namespace
{

// Step of the differences. Where the surface of 4.1 is most curved (Δ_s H = −600) their error, h⁶,
// is 1e-8 of the value; rounding, 1e-16/h², is below 1e-9.
constexpr double difference_step = 1e-3;

struct Shape
{
  Vector3 normal;
  double mean, gauss;
};

// Goldman, Computer Aided Geometric Design 22 (2005) 632: curvatures of implicit surfaces.
Shape shape_at(const LevelSet& surface, const Vector3& x)
{
  const Vector3 g = surface.gradient(x);
  const Eigen::Matrix3d A = surface.hessian(x);
  const double size = g.norm();
  Eigen::Matrix3d adjugate;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
    {
      const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, k1 = (k + 1) % 3, k2 = (k + 2) % 3;
      adjugate(k, i) = A(i1, k1) * A(i2, k2) - A(i1, k2) * A(i2, k1);
    }
  return { g / size, (size * size * A.trace() - g.dot(A * g)) / (2 * size * size * size),
    g.dot(adjugate * g) / (size * size * size * size) };
}

// First and second derivative of h along a unit vector.
std::array<double, 2> derivatives(
  const std::function<double(const Vector3&)>& h, const Vector3& x, const Vector3& along)
{
  const double s = difference_step;
  const auto at = [&](int k) { return h(x + k * s * along); };
  const double f0 = at(0), p1 = at(1), m1 = at(-1), p2 = at(2), m2 = at(-2), p3 = at(3),
               m3 = at(-3);
  return { (45 * (p1 - m1) - 9 * (p2 - m2) + (p3 - m3)) / (60 * s),
    (270 * (p1 + m1) - 27 * (p2 + m2) + 2 * (p3 + m3) - 490 * f0) / (180 * s * s) };
}

// x^a y^b ρ^−c with its gradient and Hessian.
struct Monomial
{
  int a, b, c;
  Vector3 gradient(const Vector3& x) const
  {
    const double r2 = x.squaredNorm(), r = std::pow(r2, -c / 2.);
    const auto power = [](double base, int n) { return n < 0 ? 0 : std::pow(base, n); };
    const double xa = power(x[0], a), yb = power(x[1], b);
    return Vector3(a * power(x[0], a - 1) * yb, b * xa * power(x[1], b - 1), 0) * r -
      c * xa * yb * r / r2 * x;
  }
  Eigen::Matrix3d hessian(const Vector3& x) const
  {
    const double r2 = x.squaredNorm(), r = std::pow(r2, -c / 2.);
    const auto power = [](double base, int n) { return n < 0 ? 0 : std::pow(base, n); };
    const double xa = power(x[0], a), yb = power(x[1], b);
    const Vector3 g(a * power(x[0], a - 1) * yb, b * xa * power(x[1], b - 1), 0);
    Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
    m(0, 0) = a * (a - 1) * power(x[0], a - 2) * yb;
    m(1, 1) = b * (b - 1) * xa * power(x[1], b - 2);
    m(0, 1) = m(1, 0) = a * b * power(x[0], a - 1) * power(x[1], b - 1);
    const Vector3 radial = -c * r / r2 * x; // ∇ρ^−c
    return r * m + g * radial.transpose() + radial * g.transpose() +
      xa * yb * (-c * r / r2) * (Eigen::Matrix3d::Identity() - (c + 2) / r2 * x * x.transpose());
  }
};

}

ExactCurvature exact_curvature(const LevelSet& surface, const Vector3& x)
{
  const Shape here = shape_at(surface, x);
  const auto h = [&](const Vector3& y) { return shape_at(surface, y).mean; };
  double laplacian = 0;
  for (int axis = 0; axis < 3; ++axis)
    laplacian += derivatives(h, x, Vector3::Unit(axis))[1];
  const auto [first, second] = derivatives(h, x, here.normal);
  return { here.normal, here.mean, here.gauss, laplacian - 2 * here.mean * first - second };
}

const LevelSet& ellipsoid_2_1_1_level_set()
{
  static const LevelSet surface{ [](const Vector3& x) { return Vector3(x[0] / 4, x[1], x[2]); },
    [](const Vector3&) -> Eigen::Matrix3d { return Vector3(0.25, 1, 1).asDiagonal(); } };
  return surface;
}

const LevelSet& paper_surface_level_set()
{
  // F = ρ − 1 − 0.61 x/ρ − 0.4 x² y/ρ³
  static const std::array<std::pair<double, Monomial>, 3> terms{ { { 1, { 0, 0, -1 } },
    { -0.61, { 1, 0, 1 } }, { -0.4, { 2, 1, 3 } } } };
  static const LevelSet surface{ [](const Vector3& x) -> Vector3
    {
      Vector3 sum = Vector3::Zero();
      for (const auto& [factor, term] : terms)
        sum += factor * term.gradient(x);
      return sum;
    },
    [](const Vector3& x) -> Eigen::Matrix3d
    {
      Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
      for (const auto& [factor, term] : terms)
        sum += factor * term.hessian(x);
      return sum;
    } };
  return surface;
}

}
