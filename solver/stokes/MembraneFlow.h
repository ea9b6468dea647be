#pragma once
// The flow that the forces of a membrane make, from what a frame of a run holds: the forces at the
// vertices.

#include "solver/stokes/FlowField.h"
#include "solver/surface/Surface.h"

namespace vesicle
{

/// Of force densities on the fluid at the vertices, of the membrane and gravity, N by 3, in any
/// consistent units (Simulation::fields): f = Σ N_k f_k, with f_k such that f has these values at
/// the vertices. Throws InputError if the mesh can't carry the basis. `velocities`: of the vertices,
/// for the panels to have, or empty.
FlowField membrane_flow(const TriangleMesh& mesh, SurfaceBasis basis, const Points& forces,
  const Points& velocities = {});
/// The panels that it is made of.
SurfacePanels membrane_panels(const TriangleMesh& mesh, SurfaceBasis basis, const Points& forces,
  const Points& velocities = {});

}
