#include "solver/adaptation/EqualAreaSphere.h"

#include "solver/Errors.h"
#include "solver/mesh/shapes/SphericalHarmonics.h"

#include <cmath>
#include <numbers>

namespace vesicle
{

namespace
{

constexpr int degree = 24; // of the harmonics: a red cell's rim takes that many
constexpr int steps = 16;  // of the flow, by the classical Runge–Kutta method

using Directions = Eigen::MatrixX3d;

/// A function of the direction by its harmonics.
struct OnSphere
{
  Eigen::VectorXd amplitudes;

  // Beside the sphere a polynomial in x, y and z.
  Eigen::VectorXd at(const Directions& n) const { return harmonic_sums(degree, amplitudes, n); }

  // Along two tangents, by differences of fourth order, which leave 1e-5 of the highest harmonic.
  Directions gradient(const Directions& n) const
  {
    constexpr double h = 2e-3;
    Directions sum = Directions::Zero(n.rows(), 3), tangent(n.rows(), 3);
    for (int axis = 0; axis < 2; ++axis)
    {
      for (Eigen::Index i = 0; i < n.rows(); ++i)
      {
        const Vector3 direction = n.row(i), first = direction.unitOrthogonal();
        tangent.row(i) = axis == 0 ? first : direction.cross(first);
      }
      const auto difference = [&](double step) -> Eigen::VectorXd
      { return at(n + step * tangent) - at(n - step * tangent); };
      const Eigen::VectorXd slope = (8 * difference(h) - difference(2 * h)) / (12 * h);
      sum += slope.asDiagonal() * tangent;
    }
    return sum;
  }
};

/// A surface's area a solid angle over its mean, where its vertices lie in these directions.
OnSphere density_of(const Surface& surface, const Directions& directions)
{
  const Surface sphere(*surface.space, directions);
  return { harmonic_moments(degree, sphere.points.position.rowwise().normalized(),
    surface.points.area_weight * (4 * std::numbers::pi / surface.area)) };
}

/// Its root mean square deviation from 1.
double unevenness(const OnSphere& density)
{
  return density.amplitudes.tail(density.amplitudes.size() - 1).norm() /
    std::sqrt(4 * std::numbers::pi);
}

/// Each degree l times what `factor` says.
template<class Factor>
OnSphere scaled(OnSphere function, Factor factor)
{
  for (int l = 0; l <= degree; ++l)
    function.amplitudes.segment(harmonic_index(l, -l), 2 * l + 1) *= factor(l);
  return function;
}

/// The density, as smooth as it has to be so that its harmonics don't overshoot below zero.
OnSphere positive(const OnSphere& density, const Directions& at)
{
  constexpr double least = 0.05;
  for (const double smoothing : { 0., 2., 8., 32., 128. })
  {
    OnSphere smooth =
      scaled(density, [&](int l) { return std::exp(-smoothing * l * l / (degree * degree)); });
    if (smooth.at(at).minCoeff() > least)
      return smooth;
  }
  throw InputError("the start is too thin for membrane.reference = \"sphere\": take \"start\" or a "
                   "mesh");
}

/// Directions moved until a density is even. While it goes from ρ to 1 as ρ_t = (1 − t) ρ + t, a flow v with
/// ρ_t v = ∇ψ, Δψ = ρ − 1, carries what changes.
Directions evened(const OnSphere& density, Directions n)
{
  const OnSphere potential = scaled(density, [](int l) { return l > 0 ? -1. / (l * (l + 1)) : 0; });
  const auto velocity = [&](double t, const Directions& at) -> Directions
  {
    const Directions unit = at.rowwise().normalized();
    return potential.gradient(unit).array().colwise() / ((1 - t) * density.at(unit).array() + t);
  };
  constexpr double dt = 1. / steps;
  for (int k = 0; k < steps; ++k)
  {
    const double t = k * dt;
    const Directions v1 = velocity(t, n), v2 = velocity(t + dt / 2, n + dt / 2 * v1),
                     v3 = velocity(t + dt / 2, n + dt / 2 * v2), v4 = velocity(t + dt, n + dt * v3);
    n = (n + dt / 6 * (v1 + 2 * v2 + 2 * v3 + v4)).rowwise().normalized();
  }
  return n;
}

/// As seen from the centroid.
Directions directions_of(const Surface& surface)
{
  const auto from_center = [&](const auto& points) -> Directions
  { return points.rowwise() - surface.center.transpose(); };
  if (!(from_center(surface.points.position)
          .cwiseProduct(surface.points.cross)
          .rowwise()
          .sum()
          .minCoeff() > 0))
    throw InputError("the start isn't star-shaped about its centroid, so that membrane.reference = "
                     "\"sphere\" has no place for its points: take \"start\" or a mesh");
  return from_center(surface.vertices).rowwise().normalized();
}

}

/// The root mean square of what patches of a surface are dilated by on a sphere.
static double dilation(const Surface& surface, const Points& sphere)
{
  const Eigen::VectorXd& area = surface.points.area_weight;
  const Eigen::ArrayXd change =
    Surface(*surface.space, sphere).points.area_weight.array() / area.array() - 1;
  return std::sqrt((change.square() * area.array()).sum() / surface.area);
}

// A density that had to be smoothed leaves the rest to the next round; what no round takes is finer than
// the harmonics, or the quadrature's.
Points equal_area_sphere(const Surface& surface)
{
  constexpr double even = 1e-3, gain = 0.9;
  Directions n = directions_of(surface);
  double before = HUGE_VAL;
  for (;;)
  {
    const OnSphere density = density_of(surface, n);
    const double now = unevenness(density);
    if (now < even || now > gain * before)
      break;
    n = evened(positive(density, n), n);
    before = now;
  }
  Points sphere = std::sqrt(surface.area / (4 * std::numbers::pi)) * n;
  constexpr double largest_dilation = 0.05;
  if (!(dilation(surface, sphere) < largest_dilation))
    throw InputError(
      "the mesh is too coarse for membrane.reference = \"sphere\": take more triangles");
  return sphere;
}

}
