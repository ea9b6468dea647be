#pragma once
// Splits, collapses and flips of the edges of a mesh on a smooth surface.

#include "solver/mesh/remesh/CurvedSurface.h"
#include "solver/mesh/remesh/EditableMesh.h"

#include <limits>
#include <random>

namespace vesicle
{

constexpr int no_limit = std::numeric_limits<int>::max();

/// Cuts edges longer than `length`, the longest first, on the surface near their middle: edges
/// without a common triangle and `most` at most, so that several calls are needed. Returns how
/// many.
int split_edges(DraftMesh& mesh, const CurvedSurface& surface, double length, int most = no_limit);

/// Cuts each triangle in four, the new vertices on the surface near the middles of the edges.
void cut_in_four(DraftMesh& mesh, const CurvedSurface& surface);

/// Draws edges shorter than `length`, the shortest first, together to one of their ends, where the
/// result is a manifold that faces outward without new edges longer than `longest`: edges that
/// don't disturb each other and `most` at most, so that several calls are needed. Returns how many.
int collapse_edges(DraftMesh& mesh, double length, double longest, int most = no_limit);

/// What an edge flips for.
enum class FlipGoal
{
  valences, ///< six neighbours at each vertex
  angles,   ///< Delaunay's criterion, unless vertices get far from six neighbours
};

/// Flips edges until none wants to (or would go on for ever). Vertices keep or come to 4 to 8
/// neighbours; around tips and rims sharper than the mesh edges follow the surface.
void flip_edges(DraftMesh& mesh, FlipGoal goal);

/// Flips some of the edges that are neither wanted nor in the way, so that the sum of
/// (valence − 6)² stays: pairs of vertices with five and seven neighbours wander.
void glide_edges(DraftMesh& mesh, std::mt19937& random);

}
