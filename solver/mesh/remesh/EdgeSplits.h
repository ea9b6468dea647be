#pragma once
// Splits of the edges of a mesh on a smooth surface.

#include "solver/mesh/remesh/EditableMesh.h"
#include "solver/mesh/remesh/PointNormalTriangles.h"

#include <functional>
#include <limits>

namespace vesicle
{

/// The surface's point near x, on the line through x along `direction` (unit vector) if there is one.
using SurfaceProjection =
  std::function<PointWithNormal(const Vector3& x, const Vector3& direction)>;

/// Splits edges longer than `length`, the longest first, on the surface near their middle: edges
/// without a common triangle and `most` at most, so that several calls are needed. Returns how
/// many.
int split_edges(EditableMesh& mesh, const SurfaceProjection& surface, double length,
  int most = std::numeric_limits<int>::max());

/// Cuts each triangle in four, the new vertices on the surface near the middles of the edges.
void refine(EditableMesh& mesh, const SurfaceProjection& surface);

}
