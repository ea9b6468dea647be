#pragma once
// Makes any triangulation of a closed surface uniform.

#include "solver/mesh/Relaxation.h"

#include <optional>

namespace vesicle
{

/// A mesh of `triangles` (even) triangles of nearly equal size and round shape on the surface of
/// `relaxation`. Vertices have 4 to 8 neighbours unless there are far too few triangles for the
/// shape. `start`: the edge length first aimed at, of the one wanted; it decides where the
/// extraordinary vertices end up. Nothing where no such number can be reached.
std::optional<DraftMesh> isotropic_mesh(
  const Relaxation& relaxation, int triangles, double start = 1);

}
