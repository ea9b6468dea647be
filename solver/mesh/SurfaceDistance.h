#pragma once
// How far two surfaces are from each other.

#include "solver/mesh/TriangleMesh.h"

namespace vesicle
{

/// Of the points of each from the nearest point of the other, both ways, flat triangles each.
struct SurfaceDistance
{
  double mean = 0, rms = 0;        ///< over the area of both
  double largest = 0;              ///< Hausdorff's
  Vector3 place = Vector3::Zero(); ///< the point, of either, where that is
};

/// Seen at the corners and the centroids of the triangles, which are a quadrature of second degree
/// (3/4 of the area at the centroid) for the means. Both need triangles; N log N.
SurfaceDistance surface_distance(const TriangleMesh& a, const TriangleMesh& b);

}
