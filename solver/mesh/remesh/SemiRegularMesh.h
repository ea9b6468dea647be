#pragma once
// Meshes with few extraordinary vertices: a coarse mesh of the surface, refined.

#include "solver/mesh/remesh/SurfaceSmoother.h"

#include <optional>

namespace vesicle
{

/// A mesh of `triangles` triangles, to 1%, of nearly equal size and round shape on the surface of
/// `smoother`, whose vertices have six neighbours but for those of a coarse mesh, which have five
/// to seven: of the coarsest that resolves the surface, perhaps not cut at all. Nothing if none
/// does.
std::optional<EditableMesh> semi_regular_mesh(const SurfaceSmoother& smoother, int triangles);

}
