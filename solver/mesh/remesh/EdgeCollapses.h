#pragma once
// Collapses of the edges of a mesh on a smooth surface.

#include "solver/mesh/remesh/EditableMesh.h"

#include <limits>

namespace vesicle
{

/// Collapses edges shorter than `length`, the shortest first, into one of their ends, where the
/// result is a manifold that faces outward without new edges longer than `longest`: edges that
/// don't disturb each other and `most` at most, so that several calls are needed. Returns how many.
int collapse_edges(
  EditableMesh& mesh, double length, double longest, int most = std::numeric_limits<int>::max());

}
