#pragma once
// A curved surface through the vertices of a triangle mesh, and its points along lines.

#include "solver/mesh/TriangleTree.h"
#include "solver/mesh/remesh/PointNormalTriangles.h"

#include <vector>

namespace vesicle
{

/// The patches, cut in flat pieces no longer than about `resolution` to be found.
class CurvedSurface
{
public:
  CurvedSurface(const TriangleMesh& mesh, double resolution);

  const Points& vertex_normals() const { return patches_.normals(); }
  /// The surface's point on the line through x along `direction` (unit vector), nearest to x, where
  /// the line leaves the body. Unlike the nearest point of all it doesn't slide down from a sharp
  /// tip or rim, nor jump to the other side of a thin body. The nearest one if there is none.
  PointWithNormal project_along(const Vector3& x, const Vector3& direction) const;

  /// A piece of the surface.
  struct Sample
  {
    Vector3 point;
    Vector3 normal;
    double area;
    int vertex; ///< of the mesh, a corner of the patch
  };
  std::vector<Sample> samples() const;

private:
  struct Pieces
  {
    TriangleMesh mesh;
    Points weights;         ///< barycentric, on its patch, of each point
    Points facings;         ///< of each piece
    std::vector<int> patch; ///< of each piece
  };
  Pieces cut(double resolution) const;
  void cut_patch(int number, int sides, int& points, int& triangles, Pieces& pieces) const;

  PointNormalTriangles patches_;
  Pieces pieces_;
  TriangleTree tree_;
};

}
