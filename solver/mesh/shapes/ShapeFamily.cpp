#include "solver/mesh/shapes/ShapeFamily.h"

#include "solver/Errors.h"
#include "solver/mesh/shapes/Bowl.h"
#include "solver/mesh/shapes/GeodesicSphere.h"
#include "solver/mesh/shapes/SphericalHarmonics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vesicle
{

namespace
{
SphericalParametrisation scaled_sphere(const Vector3& semi_axes)
{
  return [semi_axes](const Vector3& d) -> Vector3 { return d.cwiseProduct(semi_axes); };
}

ShapeFamily sphere()
{
  ShapeFamily family;
  family.surface = [](double) { return scaled_sphere(Vector3::Ones()); };
  return family;
}

/// Ellipsoids of revolution (1, 1, e^{± deflation}): aspect ratios up to e^5 = 148, far beyond any
/// that a mesh resolves.
ShapeFamily spheroid(double sign)
{
  ShapeFamily family;
  family.surface = [sign](double deflation)
  { return scaled_sphere(Vector3(1, 1, std::exp(sign * deflation))); };
  family.flattest = 5;
  family.needs_reduced_volume = true;
  return family;
}

Symmetry ellipsoid_symmetry(const Vector3& axes)
{
  return axes.x() == axes.y() ? Symmetry::around_z
    : axes.y() == axes.z()    ? Symmetry::around_x
    : axes.z() == axes.x()    ? Symmetry::around_y
                              : Symmetry::half_turns;
}

/// Semi-axes raised to the power `deflation`: 0 is the sphere, 1 the ellipsoid itself.
ShapeFamily ellipsoid(const std::array<double, 3>& semi_axes)
{
  const Vector3 axes(semi_axes[0], semi_axes[1], semi_axes[2]);
  if (!axes.allFinite() || !(axes.minCoeff() > 0))
  {
    throw InputError(fmt::format(
      "semi_axes = [{}, {}, {}]: the semi-axes of an ellipsoid must be positive numbers", axes.x(),
      axes.y(), axes.z()));
  }
  const double aspect = axes.maxCoeff() / axes.minCoeff();
  ShapeFamily family;
  family.surface = [axes](double power)
  { return scaled_sphere((axes / axes.maxCoeff()).array().pow(power)); };
  family.symmetry = ellipsoid_symmetry(axes);
  family.standard = 1;
  family.flattest = aspect > 1 ? std::max(1.0, 5 / std::log(aspect)) : 0;
  return family;
}

/// E. Evans, Y.-C. Fung, Microvasc. Res. 4 (1972) 335: z = ± ½ √(1 − ρ²) (c0 + c1 ρ² + c2 ρ⁴), the
/// radius of the disc as unit; on the unit sphere ±√(1 − ρ²) is just the direction's z. Shapes more
/// deflated than the measured one are this one with its height scaled by e^{−deflation}; rounder
/// ones are blended with the sphere, (1 − t) z + t z_sphere with t = 1 − e^{deflation}, deflation <
/// 0.
ShapeFamily discocyte()
{
  ShapeFamily family;
  family.surface = [](double deflation) -> SphericalParametrisation
  {
    const double height = std::exp(-std::max(deflation, 0.0));
    const double blend = -std::expm1(std::min(deflation, 0.0));
    return [height, blend](const Vector3& d) -> Vector3
    {
      const double rho2 = d.x() * d.x() + d.y() * d.y();
      const double measured = 0.5 * (0.207161 + rho2 * (2.002558 - 1.122762 * rho2));
      return { d.x(), d.y(), height * d.z() * ((1 - blend) * measured + blend) };
    };
  };
  family.roundest = -7; // within e^−7 of the sphere
  family.flattest = 3;
  return family;
}

/// Bowl.h's, whose shell is as thin as the deflation is large; a thicker one loses its mouth.
ShapeFamily stomatocyte()
{
  ShapeFamily family;
  family.surface = [](double deflation) -> SphericalParametrisation
  {
    return [half_thickness = -deflation](const Vector3& d) -> Vector3
    {
      const double polar = std::acos(std::clamp(-d.z(), -1., 1.));
      const Eigen::Vector2d p = bowl_meridian(half_thickness, polar / std::numbers::pi);
      const double across = std::hypot(d.x(), d.y()), scale = across > 0 ? p[0] / across : 0;
      return { scale * d.x(), scale * d.y(), p[1] };
    };
  };
  family.roundest = -0.6;  // v = .836
  family.flattest = -0.03; // v = .064
  family.needs_reduced_volume = true;
  family.symmetry = Symmetry::turns_about_z;
  return family;
}

double perturbed_radius(const std::vector<ShapeMode>& modes, const Vector3& direction)
{
  double radius = 1;
  for (const ShapeMode& mode : modes)
    radius += mode.amplitude * real_spherical_harmonic(mode.l, mode.m, direction);
  return radius;
}

/// Samples the radius on a grid that resolves the modes: 4 or more points a half wave of the
/// largest l.
void check_radius(const std::vector<ShapeMode>& modes)
{
  int degree = 4;
  for (const ShapeMode& mode : modes)
  {
    if (!std::isfinite(mode.amplitude))
    {
      throw InputError(
        fmt::format("mode (l, m) = ({}, {}): the amplitude isn't a number", mode.l, mode.m));
    }
    degree = std::max(degree, mode.l);
  }
  const Points directions = geodesic_sphere(std::min(4 * degree, 100)).points;
  for (const Vector3 direction : directions.rowwise())
  {
    const double radius = perturbed_radius(modes, direction);
    if (!(radius > 0))
    {
      throw InputError(
        fmt::format("the radius 1 + Σ amplitude Y_lm of the perturbed sphere is {:.4g} in "
                    "the direction ({:.4f}, {:.4f}, {:.4f}): it must be positive, so lower "
                    "the amplitudes",
          radius, direction.x(), direction.y(), direction.z()));
    }
  }
}

ShapeFamily perturbed(const std::vector<ShapeMode>& modes)
{
  check_radius(modes);
  ShapeFamily family;
  family.surface = [modes](double) -> SphericalParametrisation
  { return [modes](const Vector3& d) -> Vector3 { return perturbed_radius(modes, d) * d; }; };
  family.symmetry = modes.empty() ? Symmetry::around_z : Symmetry::none;
  return family;
}
}

ShapeFamily shape_family(const ShapeRequest& request)
{
  switch (request.kind)
  {
    case ShapeRequest::Kind::prolate:
      return spheroid(+1);
    case ShapeRequest::Kind::oblate:
      return spheroid(-1);
    case ShapeRequest::Kind::ellipsoid:
      return ellipsoid(request.semi_axes);
    case ShapeRequest::Kind::discocyte:
      return discocyte();
    case ShapeRequest::Kind::perturbed:
      return perturbed(request.modes);
    case ShapeRequest::Kind::stomatocyte:
      return stomatocyte();
    case ShapeRequest::Kind::sphere:
      break;
  }
  return sphere();
}

}
