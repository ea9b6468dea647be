#pragma once
// Bending: energy, force density, and the linear response of the force to a displacement, which
// implicit time stepping needs. All with EB = 1.

#include "solver/surface/Cotan.h"

namespace vesicle
{

/// E = 2 Σ A_i H_i² (EB = 1), paper (1) without its topological term. A sphere has 8π.
double bending_energy(const CotanGeometry& geometry, const Curvature& curvature);

/// Normal force density of the membrane on the fluid, f_b·n = 2 Δ_s H + 4 H (H² − K) (the paper's
/// (6) prints 2 for the 4): N.
Eigen::VectorXd bending_density(const Curvature& curvature);

/// Paper (25): C with f_b·n = C x, C = [2L + 4 diag(H² − K)](−½) 𝒩ᵀ(L ⊗ I₃), everything but x
/// frozen at the current shape: N by 3N. C annihilates translations.
SparseMatrix bending_matrix(const CotanGeometry& geometry, const Curvature& curvature);

/// Each row's blocks projected on the nodes' normals: M 𝒩 𝒩ᵀ, the response to the normal part of a
/// displacement. Tangential displacements of nodes change the mesh, not the shape.
SparseMatrix normal_part(const SparseMatrix& response, const Points& normal);

}
