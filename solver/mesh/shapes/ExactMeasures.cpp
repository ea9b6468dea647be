#include "solver/mesh/shapes/ExactMeasures.h"

#include "solver/mesh/shapes/ParametrisedSurface.h"

#include <cmath>
#include <numbers>

namespace vesicle
{

namespace
{
constexpr int polar_angles = 160;
constexpr int azimuths = 64; // 1 on surfaces of revolution about z

/// Fejér's weight of the height cos(angle): ∫ f(z) dz over [−1, 1].
double height_weight(double angle)
{
  double sum = 1;
  for (int j = 1; j <= polar_angles / 2; ++j)
    sum -= 2 * std::cos(2 * j * angle) / (4. * j * j - 1);
  return 2 * sum / polar_angles;
}
}

ExactMeasures exact_measures(const SphericalParametrisation& surface, Symmetry symmetry)
{
  const bool of_revolution = symmetry == Symmetry::around_z || symmetry == Symmetry::turns_about_z;
  const int around = of_revolution ? 1 : azimuths;
  ExactMeasures sum{ 0, 0, 0 };
  for (int i = 0; i < polar_angles; ++i)
  {
    const double angle = (i + 0.5) * std::numbers::pi / polar_angles, sine = std::sin(angle);
    const double solid_angle = height_weight(angle) * 2 * std::numbers::pi / around;
    for (int k = 0; k < around; ++k)
    {
      const double azimuth = 2 * std::numbers::pi * k / around;
      const SurfaceElement e = surface_element(
        surface, { sine * std::cos(azimuth), sine * std::sin(azimuth), std::cos(angle) });
      const double area = solid_angle * e.stretch;
      sum.area += area;
      sum.volume += area * e.point.dot(e.normal) / 3;
      sum.bending_energy += area * 2 * e.mean * e.mean;
    }
  }
  return sum;
}

}
