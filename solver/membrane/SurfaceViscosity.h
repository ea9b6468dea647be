#pragma once
// The viscosity of a fluid membrane: its resistance to shear within itself. L. E. Scriven, Chem. Eng.
// Sci. 12 (1960) 98.

#include "solver/surface/Surface.h"

namespace vesicle
{

/// V of the dissipation u·V u = ∮ 2 η e:e dS, 3N by 3N, the nodes' blocks 3 by 3, for velocities u of
/// the control points: e, 1/T, is the traceless part of their surface rate of strain P (∇_s u + ∇_s uᵀ)/2 P,
/// `viscosity` η > 0 a viscosity times a length. The membrane's load on the fluid is −V u, the exact
/// derivative of half the dissipation as it is integrated. Symmetric and never negative. A rigid
/// motion has none, nor has a growth of area that is the same in all directions: there is no
/// dilational viscosity, so that an incompressible membrane isn't held twice.
SparseMatrix viscosity_matrix(const Surface& surface, double viscosity);

}
