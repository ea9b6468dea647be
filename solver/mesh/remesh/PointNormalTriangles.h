#pragma once
// A curved surface over the triangles of a mesh.

#include "solver/mesh/TriangleMesh.h"

namespace vesicle
{

struct PointWithNormal
{
  Vector3 point;
  Vector3 normal; ///< outward unit vector
};

/// Over each triangle a cubic patch from its corners and their normals: curved point-normal
/// triangles (A. Vlachos, J. Peters, C. Boyd, J. L. Mitchell, Proc. I3D 2001, 159–166). The patches
/// meet along the edges, nearly smoothly.
class PointNormalTriangles
{
public:
  /// `mesh`: closed, facing outward.
  explicit PointNormalTriangles(const TriangleMesh& mesh);

  const TriangleMesh& mesh() const { return mesh_; }
  const Points& normals() const { return normals_; }
  double longest_side(int patch) const;
  /// The point of a patch with these barycentric weights.
  PointWithNormal point(int patch, const Vector3& weights) const;

private:
  TriangleMesh mesh_;
  Points normals_; ///< at the vertices
};

}
