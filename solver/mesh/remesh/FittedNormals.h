#pragma once
// Normals at the vertices of a triangulated smooth surface, also where the triangles are uneven.

#include "solver/mesh/TriangleMesh.h"

namespace vesicle
{

/// Outward unit normals at the vertices of a closed, oriented mesh, one a row: those of quadratics
/// through each vertex, fitted to its two-ring. The error is of order h² on a smooth surface,
/// whatever the triangles; averaged triangle normals are of order h only where the ring is uneven.
/// Where no quadratic fits (few neighbours, an edge of the body) the average with N. Max's weights.
Points fitted_normals(const TriangleMesh& mesh);

}
