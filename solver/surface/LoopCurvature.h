#pragma once
// Curvatures of the Loop limit surface through the vertices of a mesh: time and memory grow as the
// number of triangles.

#include "solver/ProgressCallback.h"
#include "solver/surface/Cotan.h"

namespace vesicle
{

/// At the vertices of a closed manifold mesh, as vertex_curvature() has them of a smooth Surface: H
/// and K are projected onto the basis from the quadrature points, Δ_s H comes from the projected
/// bending force. Throws InputError for other meshes.
Curvature loop_curvature(const TriangleMesh& mesh, const ProgressCallback& progress = {});

}
