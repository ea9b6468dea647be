#include "solver/Errors.h"
#include "solver/mesh/Shapes.h"

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <cstdlib>
#include <numbers>

namespace vesicle
{

// Y_lm = √2 P_l^|m| cos mφ (m > 0), P_l^0 (m = 0), √2 P_l^|m| sin |m|φ (m < 0) with P_l^m
// normalised so that ∮Y² = 1 and without the Condon–Shortley sign: Y_11 = √(3/4π) x. The recurrence
// upward in l at fixed m is the stable one (Press et al., Numerical Recipes, 6.7).
double real_spherical_harmonic(int l, int m, const Vector3& d)
{
  const int order = std::abs(m);
  if (l < 0 || order > l)
  {
    throw InputError(
      fmt::format("there is no spherical harmonic (l, m) = ({}, {}): |m| ≤ l is needed", l, m));
  }
  double sectoral = std::sqrt(0.25 / std::numbers::pi); // P_m^m / sin^m θ
  for (int k = 1; k <= order; ++k)
  {
    sectoral *= std::sqrt((2.0 * k + 1) / (2.0 * k));
  }
  double below = 0;
  double legendre = sectoral;
  for (int k = order + 1; k <= l; ++k)
  {
    const auto alpha = [order](double j)
    { return std::sqrt((4 * j * j - 1) / (j * j - double(order) * order)); };
    const double previous = k > order + 1 ? below / alpha(k - 1) : 0;
    below = legendre;
    legendre = alpha(k) * (d.z() * legendre - previous);
  }
  std::complex<double> azimuth = 1; // (x + iy)^m = sin^m θ e^{imφ}
  for (int k = 0; k < order; ++k)
  {
    azimuth *= std::complex<double>(d.x(), d.y());
  }
  if (m == 0)
  {
    return legendre;
  }
  return std::numbers::sqrt2 * legendre * (m > 0 ? azimuth.real() : azimuth.imag());
}

}
