#pragma once
// Loop's limit surface as fine flat triangles.

#include "solver/mesh/TriangleMesh.h"

namespace vesicle
{

/// Each triangle of a closed manifold mesh as cuts² flat ones with their corners on Loop's surface
/// through the mesh's points, which they are within 1/cuts² of the mesh's own triangles' distance
/// of. Triangles of different elements share no points. Throws InputError for other meshes.
TriangleMesh limit_triangles(const TriangleMesh& mesh, int cuts);

}
