#include "solver/dynamics/SurfaceMeasures.h"

#include "solver/dynamics/Discretization.h"
#include "solver/membrane/Bending.h"
#include "solver/mesh/MeshIntegrals.h"

#include <cmath>
#include <numbers>

namespace vesicle
{

static SurfaceMeasures flat_measures(const TriangleMesh& mesh)
{
  const CotanGeometry geometry(mesh.points, mesh.triangles);
  const Curvature curvature = cotan_curvature(geometry, mesh.points, NormalScheme::area_weighted);
  return { flat_area(mesh), flat_volume(mesh), bending_energy(geometry, curvature) };
}

static SurfaceMeasures loop_measures(const TriangleMesh& mesh)
{
  constexpr int quadrature = 3; // of velocities, of which there are none
  const auto surface = make_loop_discretization(
    Model(), mesh.triangles, static_cast<int>(mesh.points.rows()), quadrature);
  const Constraints c = surface->constraints(mesh.points);
  return { c.area, c.volume, surface->bending_energy(mesh.points) };
}

SurfaceMeasures surface_measures(SurfaceBasis basis, const TriangleMesh& mesh)
{
  return basis == SurfaceBasis::linear ? flat_measures(mesh) : loop_measures(mesh);
}

double equivalent_radius(double volume)
{
  return std::cbrt(3 * volume / (4 * std::numbers::pi));
}

}
