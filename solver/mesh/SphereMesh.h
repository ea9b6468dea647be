#pragma once
// Triangulations of the unit sphere that carry the mesh of a shape: directions and the triangles
// between them, together with the half turns that map the triangulation onto itself.

#include "solver/mesh/TriangleMesh.h"

#include <vector>

namespace vesicle
{

struct SphereMesh
{
  Points directions; ///< unit vectors
  Triangles triangles;
  /// For the half turns about x, y and z: the vertex each vertex is turned into. Empty: the mesh
  /// needn't be symmetric.
  std::vector<std::vector<int>> half_turns;
};

/// geodesic_sphere(n), with its half turns if `symmetric`.
SphereMesh geodesic_sphere_mesh(int n, bool symmetric);

/// Each triangle cut into four, the new vertices at the edges' midpoints (of the directions).
SphereMesh cut_in_four(const SphereMesh& mesh);

/// d turned by 180° about coordinate axis `axis`.
inline Vector3 half_turn(const Vector3& d, int axis)
{
  Vector3 turned = -d;
  turned[axis] = d[axis];
  return turned;
}

}
