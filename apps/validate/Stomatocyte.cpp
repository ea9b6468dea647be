#include "apps/validate/Stomatocyte.h"

#include "solver/mesh/MeshIntegrals.h"
#include "solver/mesh/shapes/Bowl.h"
#include "solver/surface/StartShape.h"
#include "solver/surface/SurfaceMeasures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vesicle::validation
{
namespace
{

SphericalParametrisation bowl(double h)
{
  return [h](const Vector3& d) -> Vector3
  {
    const double polar = std::acos(std::clamp(-d.z(), -1., 1.));
    const Eigen::Vector2d p = bowl_meridian(h, polar / std::numbers::pi);
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
    // Even triangles don't see its rim: of 320 at v = .5 the energy is ten times too high.
    directions = loop_mesh(bowl(h), scene.vesicle.shape.triangles, Symmetry::turns_about_z);
    h = solve_thickness(basis, directions, v);
  }
  TriangleMesh mesh = mapped(directions, bowl(h));
  mesh.points /= equivalent_radius(surface_measures(basis, mesh).volume);
  return mesh;
}

}
