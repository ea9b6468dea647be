#include "solver/stokes/MembraneFlow.h"

#include "solver/surface/LoopBasis.h"

namespace vesicle
{

namespace
{

SurfacePanels panels_of(
  const Basis& basis, const TriangleMesh& mesh, const Points& forces, const Points& velocities)
{
  const Collocation collocation(basis);
  return { basis, collocation.fit(mesh.points), nodal_density(collocation.fit(forces)),
    velocities.rows() > 0 ? Points(collocation.fit(velocities)) : Points() };
}

}

SurfacePanels membrane_panels(
  const TriangleMesh& mesh, SurfaceBasis basis, const Points& forces, const Points& velocities)
{
  const int nodes = static_cast<int>(mesh.points.rows());
  return basis == SurfaceBasis::loop
    ? panels_of(LoopBasis(mesh.triangles, nodes), mesh, forces, velocities)
    : panels_of(LinearBasis(mesh.triangles, nodes), mesh, forces, velocities);
}

FlowField membrane_flow(
  const TriangleMesh& mesh, SurfaceBasis basis, const Points& forces, const Points& velocities)
{
  return FlowField(membrane_panels(mesh, basis, forces, velocities));
}

}
