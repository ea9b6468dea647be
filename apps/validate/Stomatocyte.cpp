#include "apps/validate/Stomatocyte.h"

#include "solver/mesh/MeshIntegrals.h"
#include "solver/mesh/shapes/UniformMesh.h"
#include "solver/surface/SurfaceMeasures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vesicle::validation
{
namespace
{

// Radius of the hole, in middle radii of the shell: the branch's shapes have narrower ones, but the
// triangles of an open bowl have room.
constexpr double hole = 0.25;

/// Point of the meridian at the share s of its length, from the outer pole (bottom) to the inner
/// one. Middle radius 1, half thickness h.
Eigen::Vector2d meridian(double h, double s)
{
  const double reach = std::numbers::pi - std::asin(std::min(1., hole + h)); // to the rim
  const double outer = (1 + h) * reach, rim = std::numbers::pi * h, inner = (1 - h) * reach;
  double way = s * (outer + rim + inner);
  const auto on_circle = [](double radius, double angle) -> Eigen::Vector2d {
    return { radius * std::sin(angle), -radius * std::cos(angle) };
  };
  if (way <= outer)
  {
    return on_circle(1 + h, way / (1 + h));
  }
  way -= outer;
  if (way <= rim)
  {
    const double turn = way / h; // 0 outside, π inside
    return on_circle(1 + h * std::cos(turn), reach) +
      h * std::sin(turn) * Eigen::Vector2d(std::cos(reach), std::sin(reach));
  }
  return on_circle(1 - h, reach - (way - rim) / (1 - h));
}

SphericalParametrisation bowl(double h)
{
  return [h](const Vector3& d) -> Vector3
  {
    const double polar = std::acos(std::clamp(-d.z(), -1., 1.));
    const Eigen::Vector2d p = meridian(h, polar / std::numbers::pi);
    const double across = std::hypot(d.x(), d.y());
    const double scale = across > 0 ? p[0] / across : 0;
    return { scale * d.x(), scale * d.y(), p[1] };
  };
}

/// The half thickness with the reduced volume v above fixed directions: the thicker, the rounder.
double solve_thickness(SurfaceBasis basis, const SphereMesh& directions, double v)
{
  double low = 0.02, high = 0.6;
  for (int step = 0; step < 60 && high - low > 1e-9; ++step)
  {
    const double h = (low + high) / 2;
    const SurfaceMeasures m = surface_measures(basis, mapped(directions, bowl(h)));
    (reduced_volume(m.area, m.volume) > v ? high : low) = h;
  }
  return (low + high) / 2;
}

}

TriangleMesh stomatocyte(const Scene& scene, double v)
{
  const SurfaceBasis basis = scene.accuracy.basis;
  double h = v / 2; // nearly, of such shells
  SphereMesh directions;
  for (int sweep = 0; sweep < 2; ++sweep)
  {
    directions = uniform_mesh(bowl(h), scene.vesicle.shape.triangles, Symmetry::none);
    h = solve_thickness(basis, directions, v);
  }
  TriangleMesh mesh = mapped(directions, bowl(h));
  mesh.points /= equivalent_radius(surface_measures(basis, mesh).volume);
  return mesh;
}

}
