#include "solver/mesh/shapes/SphericalHarmonics.h"

#include "solver/Errors.h"

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <cstdlib>
#include <numbers>

namespace vesicle
{
namespace
{

// Calls visit(l, P_l^m / sin^m θ) for l = m … degree; z = cos θ is a number or an array of them.
// The recurrence upward in l at fixed m is the stable one (Press et al., Numerical Recipes, 6.7).
template<class Number, class Visit>
void for_each_legendre(int m, int degree, const Number& z, Visit visit)
{
  const auto alpha = [m](double l) { return std::sqrt((4 * l * l - 1) / (l * l - double(m) * m)); };
  double sectoral = std::sqrt(0.25 / std::numbers::pi); // P_m^m / sin^m θ
  for (int k = 1; k <= m; ++k)
    sectoral *= std::sqrt((2.0 * k + 1) / (2.0 * k));
  Number below = 0 * z;
  Number legendre = below + sectoral;
  visit(m, legendre);
  for (int l = m + 1; l <= degree; ++l)
  {
    const double share = l > m + 1 ? 1 / alpha(l - 1) : 0;
    const Number next = alpha(l) * (z * legendre - share * below);
    below = legendre;
    legendre = next;
    visit(l, legendre);
  }
}

}

double real_spherical_harmonic(int l, int m, const Eigen::Vector3d& d)
{
  const int order = std::abs(m);
  if (l < 0 || order > l)
  {
    throw InputError(
      fmt::format("there is no spherical harmonic (l, m) = ({}, {}): |m| ≤ l is needed", l, m));
  }
  double legendre = 0;
  for_each_legendre(order, l, d.z(), [&](int, double value) { legendre = value; });
  std::complex<double> azimuth = 1; // (x + iy)^m = sin^m θ e^{imφ}
  for (int k = 0; k < order; ++k)
    azimuth *= std::complex<double>(d.x(), d.y());
  if (m == 0)
    return legendre;
  return std::numbers::sqrt2 * legendre * (m > 0 ? azimuth.real() : azimuth.imag());
}

namespace
{

// Calls visit(m, cosine, sine) for m = 0 … degree: weight · (x + iy)^m, √2 of it for m > 0.
template<class Visit>
void for_each_azimuth(
  int degree, const Eigen::MatrixX3d& directions, const Eigen::ArrayXd& weights, Visit visit)
{
  const Eigen::ArrayXd x = directions.col(0), y = directions.col(1);
  Eigen::ArrayXd cosine = weights, sine = Eigen::ArrayXd::Zero(weights.size());
  for (int m = 0; m <= degree; ++m)
  {
    visit(m, cosine, sine);
    const double factor = m == 0 ? std::numbers::sqrt2 : 1;
    const Eigen::ArrayXd next = factor * (x * cosine - y * sine);
    sine = factor * (x * sine + y * cosine);
    cosine = next;
  }
}

}

Eigen::VectorXd harmonic_moments(
  int degree, const Eigen::MatrixX3d& directions, const Eigen::VectorXd& weights)
{
  using Array = Eigen::ArrayXd;
  const Array z = directions.col(2);
  Eigen::VectorXd moments(harmonic_count(degree));
  for_each_azimuth(degree, directions, weights,
    [&](int m, const Array& cosine, const Array& sine)
    {
      for_each_legendre(m, degree, z,
        [&](int l, const Array& legendre)
        {
          moments[harmonic_index(l, m)] = (cosine * legendre).sum();
          if (m > 0)
            moments[harmonic_index(l, -m)] = (sine * legendre).sum();
        });
    });
  return moments;
}

Eigen::VectorXd harmonic_sums(
  int degree, const Eigen::VectorXd& amplitudes, const Eigen::MatrixX3d& directions)
{
  using Array = Eigen::ArrayXd;
  const Array z = directions.col(2);
  Array sums = Array::Zero(z.size());
  for_each_azimuth(degree, directions, Array::Ones(z.size()),
    [&](int m, const Array& cosine, const Array& sine)
    {
      for_each_legendre(m, degree, z,
        [&](int l, const Array& legendre)
        {
          sums += amplitudes[harmonic_index(l, m)] * cosine * legendre;
          if (m > 0)
            sums += amplitudes[harmonic_index(l, -m)] * sine * legendre;
        });
    });
  return sums;
}

}
