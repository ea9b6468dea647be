#include "solver/stokes/MembraneFlow.h"

#include "solver/surface/LoopBasis.h"

namespace vesicle
{

namespace
{

FlowField linear_flow(const TriangleMesh& mesh, const VertexForces& forces)
{
  const LinearBasis basis(mesh.triangles, static_cast<int>(mesh.points.rows()));
  return FlowField(SurfacePanels(basis, mesh.points, nodal_density(forces.total)));
}

FlowField loop_flow(const TriangleMesh& mesh, const VertexForces& forces)
{
  const LoopBasis basis(mesh.triangles, static_cast<int>(mesh.points.rows()));
  const Collocation collocation(basis);
  const Points control = collocation.fit(mesh.points);
  const Points normal = basis.vertex_normals(control);
  const bool with_tension = forces.tension.size() > 0;
  const Points other = with_tension ? Points(forces.total - forces.tension_force) : forces.total;
  const Eigen::VectorXd pressure = other.cwiseProduct(normal).rowwise().sum();
  const Points rest = other - (normal.array().colwise() * pressure.array()).matrix();

  ForceDensity density =
    nodal_density(collocation.fit(rest)) + normal_density(collocation.fit(pressure));
  if (with_tension)
    density = density + tension_density(control, collocation.fit(forces.tension));
  return FlowField(SurfacePanels(basis, control, density));
}

}

FlowField membrane_flow(const TriangleMesh& mesh, SurfaceBasis basis, const VertexForces& forces)
{
  return basis == SurfaceBasis::loop ? loop_flow(mesh, forces) : linear_flow(mesh, forces);
}

}
