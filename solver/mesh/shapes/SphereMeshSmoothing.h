#pragma once
// Makes the mesh of a smooth surface uniform and well shaped: nodes move along the exact surface,
// the triangulation stays.

#include "solver/mesh/shapes/SphereMesh.h"

namespace vesicle
{

/// `passes` rounds of tangential smoothing of the mesh on `surface`. The directions always
/// triangulate the sphere, so that the surface is covered once; symmetries are kept.
void smooth(SphereMesh& mesh, const SphericalParametrisation& surface, int passes);

}
