#pragma once
// Flips of the edges of a mesh on a smooth surface.

#include "solver/mesh/remesh/EditableMesh.h"

#include <random>

namespace vesicle
{

/// What an edge flips for.
enum class FlipGoal
{
  valences, ///< six neighbours at each vertex
  angles,   ///< Delaunay's criterion, unless vertices get far from six neighbours
};

/// Flips edges until none wants to (or would go on for ever). Vertices keep or come to 4 to 8
/// neighbours; around tips and rims sharper than the mesh edges follow the surface.
void flip_edges(EditableMesh& mesh, FlipGoal goal);

/// Flips some of the edges that are neither wanted nor in the way, so that the sum of
/// (valence − 6)² stays: dislocations, pairs of neighbours with five and seven neighbours, glide.
void glide_dislocations(EditableMesh& mesh, std::mt19937& random);

}
