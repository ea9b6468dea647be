#pragma once
// Gives the mesh of a smooth surface triangles of good shapes and of the sizes that are wanted: nodes
// move along the exact surface, the triangulation stays. The directions always triangulate the
// sphere, so that the surface is covered once; symmetries are kept.

#include "solver/mesh/shapes/SphereMesh.h"

namespace vesicle
{

/// `passes` rounds towards triangles of one size.
void smooth(SphereMesh& mesh, const SphericalParametrisation& surface, int passes);

/// `passes` rounds towards triangles as large as the surface's curvature lets them be, by
/// SizingLaw.h. Returns a score to rank meshes by, 60 at best: the smallest angle by how evenly the
/// edges have the lengths that are wanted, shortest to longest.
double grade(SphereMesh& mesh, const SphericalParametrisation& surface, int passes);

}
