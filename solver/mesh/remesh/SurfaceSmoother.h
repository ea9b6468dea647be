#pragma once
// Smoothing of a mesh along a curved surface, its triangles fixed.

#include "solver/mesh/remesh/CurvedSurface.h"
#include "solver/mesh/remesh/EditableMesh.h"

namespace vesicle
{

/// The curved surface through an input's vertices, and the smoothing of meshes on it.
/// Smoothing towards the neighbours pulls a mesh off tips and rims sharper than its edges, and in
/// the end into a thin body: there vertices move to the centroids of the surface that is nearest to
/// them instead (S. Lloyd, IEEE Trans. Inf. Theory 28 (1982) 129–137), by which all of it stays
/// covered.
class SurfaceSmoother
{
public:
  /// For meshes of up to `triangles` triangles. `input`: closed, outward, of size about 1.
  SurfaceSmoother(const TriangleMesh& input, int triangles);

  PointWithNormal project_along(const Vector3& x, const Vector3& direction) const
  {
    return surface_.project_along(x, direction);
  }
  const std::vector<CurvedSurface::Sample>& samples() const { return samples_; }
  double area() const { return area_; }
  /// The input itself. The references of a mesh are for each of the surface's samples the nearest
  /// vertex.
  const EditableMesh& input() const { return input_; }
  /// Moves the vertices to the centroids of their triangles where the mesh resolves the surface, of
  /// their cells where it doesn't; no triangle folds over.
  void smooth(EditableMesh& mesh) const;

private:
  void find_nearest_vertices(EditableMesh& mesh) const;
  void move_without_folding(
    EditableMesh& mesh, const Points& targets, const Points& directions) const;

  CurvedSurface surface_;
  std::vector<CurvedSurface::Sample> samples_;
  double area_ = 0;
  EditableMesh input_;
};

}
