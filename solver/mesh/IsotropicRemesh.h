#pragma once
// Makes any triangulation of a closed surface uniform.

#include "solver/mesh/Relaxation.h"

#include <optional>

namespace vesicle
{

/// A mesh of `triangles` (even) triangles of nearly equal size and round shape on the surface of
/// `relaxation`. Vertices have 4 to 8 neighbours unless there are far too few triangles for the
/// shape. Nothing where no such number can be reached.
std::optional<DraftMesh> isotropic_mesh(const Relaxation& relaxation, int triangles);

/// The same with fewer extraordinary vertices, less well shaped where it doesn't resolve the
/// surface. `start`: the edge length first aimed at, of the one wanted; what is left of
/// extraordinary vertices depends on it.
std::optional<DraftMesh> ordered_mesh(const Relaxation& relaxation, int triangles, double start);

}
