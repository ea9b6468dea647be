#pragma once
// Smoothing of a mesh along a curved surface, its triangles fixed.

#include "solver/mesh/remesh/CurvedSurface.h"
#include "solver/mesh/remesh/EditableMesh.h"

namespace vesicle
{

/// Of the number of triangles asked for, relatively, where a better mesh has another one.
constexpr double allowed_deviation = 0.01;

/// The side of `triangles` equilateral triangles of area `area` in all.
double mean_edge(double area, int triangles);

/// The curved surface through an input's vertices, and meshes on it that are drawn smooth.
/// Smoothing towards the neighbours draws a mesh off tips and rims sharper than its edges, and in
/// the end into a thin body: there vertices move to the centroids of the surface that is nearest to
/// them instead (S. Lloyd, IEEE Trans. Inf. Theory 28 (1982) 129–137), by which all of it stays
/// covered.
class Relaxation
{
public:
  /// For meshes of up to `triangles` triangles. `input`: closed, outward, of size about 1.
  Relaxation(const TriangleMesh& input, int triangles);

  const CurvedSurface& surface() const { return surface_; }
  const std::vector<CurvedSurface::Sample>& samples() const { return samples_; }
  double area() const { return area_; }
  /// The input itself. The references of a draft are for each of the surface's samples the nearest
  /// vertex.
  const DraftMesh& input() const { return input_; }
  /// Moves the vertices to the centroids of their triangles where the mesh resolves the surface, of
  /// their cells where it doesn't; no triangle folds over.
  void relax(DraftMesh& draft) const;

private:
  void find_owners(DraftMesh& draft) const;
  void move_without_folding(
    DraftMesh& draft, const Points& targets, const Points& directions) const;

  CurvedSurface surface_;
  std::vector<CurvedSurface::Sample> samples_;
  double area_ = 0;
  DraftMesh input_;
};

}
