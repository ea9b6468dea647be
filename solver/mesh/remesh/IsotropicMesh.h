#pragma once
// Makes any triangulation of a closed surface uniform.

#include "solver/mesh/remesh/SurfaceSmoother.h"

#include <optional>

namespace vesicle
{

/// What a mesh is made for.
enum class MeshGoal
{
  triangle_shape, ///< well shaped triangles
  regularity,     ///< few extraordinary vertices; less well shaped where the surface isn't resolved
};

/// A mesh of `triangles` (even) triangles of nearly equal size and round shape on the surface of
/// `smoother`. Vertices have 4 to 8 neighbours unless there are far too few triangles for the
/// shape. `start`: the edge length first aimed at, of the one wanted; how many extraordinary
/// vertices are left depends on it. Nothing where no such number can be reached.
std::optional<EditableMesh> isotropic_mesh(
  const SurfaceSmoother& smoother, int triangles, MeshGoal goal, double start = 1);

}
