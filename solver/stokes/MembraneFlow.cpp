#include "solver/stokes/MembraneFlow.h"

#include "solver/surface/LoopBasis.h"

namespace vesicle
{

namespace
{

FlowField flow_of(const Basis& basis, const TriangleMesh& mesh, const Points& forces)
{
  const Collocation collocation(basis);
  return FlowField(
    SurfacePanels(basis, collocation.fit(mesh.points), nodal_density(collocation.fit(forces))));
}

}

FlowField membrane_flow(const TriangleMesh& mesh, SurfaceBasis basis, const Points& forces)
{
  const int nodes = static_cast<int>(mesh.points.rows());
  return basis == SurfaceBasis::loop ? flow_of(LoopBasis(mesh.triangles, nodes), mesh, forces)
                                     : flow_of(LinearBasis(mesh.triangles, nodes), mesh, forces);
}

}
