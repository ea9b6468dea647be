#pragma once
// Triangulations of the unit sphere, above which the mesh of a surface lies: directions and the
// triangles between them, together with the rotations that map the triangulation onto itself.

#include "solver/mesh/shapes/SphericalParametrisation.h"

#include <vector>

namespace vesicle
{

/// A rotation that maps a triangulation onto itself.
struct SymmetryOperation
{
  Eigen::Matrix3d rotation;
  std::vector<int> image; ///< the vertex that each vertex comes to
};

struct SphereMesh
{
  Points directions; ///< unit vectors
  Triangles triangles;
  /// A group, but for the identity; none if the mesh needn't be symmetric.
  std::vector<SymmetryOperation> symmetries;
};

/// geodesic_sphere(n) without symmetries.
SphereMesh geodesic_sphere_mesh(int n);

/// Those operations of the dihedral group that map the mesh onto itself: `fold` turns about z, each
/// with and without a half turn about y. With a fold of 2 the half turns about the axes.
std::vector<SymmetryOperation> dihedral_symmetries(const SphereMesh& mesh, int fold);

/// The coordinate axes and all that goes with them, one on: z becomes x.
SphereMesh axes_permuted(const SphereMesh& mesh);

/// Each triangle cut into four, the new vertices at the edges' midpoints (of the directions).
SphereMesh refined(const SphereMesh& mesh);

/// The flat triangles through the surface's points above mesh.directions.
TriangleMesh mapped(const SphereMesh& mesh, const SphericalParametrisation& surface);

}
