#pragma once
// Triangle meshes of axisymmetric surfaces, graded by curvature, as starts for the search of an
// equilibrium.

#include "solver/equilibrium/AxisymmetricShape.h"
#include "solver/mesh/TriangleMesh.h"

namespace vesicle
{

/// A capped tube (CappedTube.h) with about as many triangles around as the surface wants, its vertices
/// on the meridian's surface and spread by the sizing law. `triangles`: the nearest multiple of 10 or
/// 12. Throws InputError if they are too few.
TriangleMesh meridian_mesh(const Meridian& meridian, EquilibriumBranch branch, int triangles);

}
