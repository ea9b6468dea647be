#pragma once
// Triangulations of the unit sphere that carry the mesh of a shape: directions and the triangles
// between them, together with the turns that map the triangulation onto itself.

#include "solver/mesh/TriangleMesh.h"

#include <vector>

namespace vesicle
{

/// A rotation, and the vertex that each vertex is turned into.
struct Turn
{
  Eigen::Matrix3d rotation;
  std::vector<int> image;
};

struct SphereMesh
{
  Points directions; ///< unit vectors
  Triangles triangles;
  std::vector<Turn> turns; ///< a group, but for the identity; none if it needn't be symmetric
};

/// geodesic_sphere(n) without turns.
SphereMesh geodesic_sphere_mesh(int n);

/// Those of the dihedral group's turns that map the mesh onto itself: `fold` turns about z, each
/// with and without a half turn about y. With a fold of 2 the half turns about the axes.
std::vector<Turn> dihedral_turns(const SphereMesh& mesh, int fold);

/// The coordinate axes and all that goes with them, one on: z becomes x.
SphereMesh turned_over(const SphereMesh& mesh);

/// Each triangle cut into four, the new vertices at the edges' midpoints (of the directions).
SphereMesh cut_in_four(const SphereMesh& mesh);

}
