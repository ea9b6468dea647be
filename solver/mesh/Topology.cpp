#include "solver/mesh/Topology.h"

#include "solver/mesh/MeshInspection.h"

namespace vesicle
{

// Euler's formula, summed over the components: points − edges + triangles = Σ (2 − 2 genus).
Topology topology(const TriangleMesh& mesh)
{
  const MeshInspection inspection(mesh);
  Topology result;
  result.closed = mesh.triangles.rows() > 0 && inspection.first_border_edge() < 0;
  result.manifold =
    inspection.first_nonmanifold_edge() < 0 && inspection.first_nonmanifold_vertex() < 0;
  result.oriented = inspection.oriented();
  result.components = static_cast<int>(inspection.component_vertices().size());
  if (result.closed && result.manifold && result.oriented)
  {
    const int euler = inspection.used_vertices() - inspection.edges().size() +
      static_cast<int>(mesh.triangles.rows());
    result.genus = result.components - euler / 2;
  }
  return result;
}

}
