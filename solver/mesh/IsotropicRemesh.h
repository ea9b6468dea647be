#pragma once
// Makes any triangulation of a closed surface uniform.

#include "solver/mesh/TriangleMesh.h"

namespace vesicle
{

/// A mesh of `triangles` (even) triangles of nearly equal size and round shape, with its vertices
/// on the curved surface through the input's vertices. `input`: closed, outward, of size about 1.
/// Vertices have 4 to 8 neighbours unless there are far too few triangles for the shape. Throws
/// InputError where no such number can be reached.
TriangleMesh isotropic_mesh(const TriangleMesh& input, int triangles);

}
