#include "solver/surface/SurfaceMeasures.h"

#include "solver/surface/Surface.h"
#include "solver/mesh/MeshIntegrals.h"

#include <cmath>
#include <numbers>

namespace vesicle
{

namespace
{

SurfaceMeasures flat_measures(const TriangleMesh& mesh)
{
  const CotanGeometry geometry(mesh.points, mesh.triangles);
  const Curvature curvature = cotan_curvature(geometry, mesh.points, NormalScheme::area_weighted);
  return { flat_area(mesh), flat_volume(mesh),
    2 * geometry.vertex_area.dot(curvature.mean.cwiseAbs2()) };
}

SurfaceMeasures loop_measures(const TriangleMesh& mesh)
{
  const SurfaceSpace space(
    SurfaceBasis::loop, mesh.triangles, static_cast<int>(mesh.points.rows()));
  const Points control = space.collocation().fit(mesh.points);
  const BasisTable& table = space.table();
  const SurfacePoints points = evaluate(table, control);
  return { area(points), volume(table, points),
    2 * points.area_weight.dot(mean_curvature(table, points, control).cwiseAbs2()) };
}

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
