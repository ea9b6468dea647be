#pragma once
// The flow that the forces of a membrane make, from what a frame of a run holds: the forces at the
// vertices.

#include "solver/stokes/FlowField.h"
#include "solver/surface/Surface.h"

namespace vesicle
{

/// Force densities on the fluid at the vertices, in any consistent units (Simulation::fields).
struct VertexForces
{
  Points total; ///< of the membrane and gravity: N by 3
  /// The part of `total` that comes from the tension, and the tension: both or neither. On a smooth
  /// basis the force is then ∇_s γ − 2 H γ n itself, as in the dynamics, instead of an
  /// interpolation of its values at the vertices.
  Points tension_force;
  Eigen::VectorXd tension;
};

/// Linear elements: f = Σ N_k f_k. Loop: what isn't from the tension is split in its normal part
/// p n, with n the surface's own, and the rest, both interpolated. Throws InputError if the mesh
/// can't carry the basis.
FlowField membrane_flow(const TriangleMesh& mesh, SurfaceBasis basis, const VertexForces& forces);

}
