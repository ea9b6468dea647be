#pragma once
// A surface cut into flat triangles fine enough to measure along lines on it.

#include "solver/surface/Surface.h"

namespace vesicle
{

/// Flat triangles and a vector field at their corners; corners may be repeated.
struct FlatSample
{
  TriangleMesh mesh;
  Points field;
};

/// Flat triangles as they are; elements of smooth surfaces in sixteen pieces each, sixteen times
/// nearer to the surface than the elements' own chords. Made once for all shapes of a mesh.
class FlatPieces
{
public:
  explicit FlatPieces(const SurfaceSpace& space);

  /// At least the part of the surface that the plane y = `height` cuts; `field` is given at the
  /// vertices.
  FlatSample around(double height, const Surface& surface, const Points& field) const;

private:
  std::vector<std::array<double, 2>> points_; ///< (u, v): an element's corners, then the others
  std::vector<std::array<int, 3>> pieces_;
  BasisTable inner_; ///< all points but the corners, element by element
};

}
