#pragma once
// Polygons cut into triangles.

#include "solver/mesh/PolygonMesh.h"

namespace vesicle
{

struct Triangulation
{
  Triangles triangles;
  std::vector<std::int64_t> cell; ///< of the polygon that each triangle is a part of
};

/// Cuts polygons into triangles on their own corners by clipping ears in the plane of the polygon's
/// vector area (Newell's), so that concave polygons keep their area; corners on a straight side
/// stay corners of triangles. Repeated corners count once, and polygons with fewer than three
/// different ones have no triangles. Where sides of a polygon cross each other the triangles fill
/// it somehow. Corners must be among the points. Throws InputError naming the face where a polygon
/// of thousands of corners is too intricate to be cut in a time proportional to its size.
Triangulation triangulate(
  const Points& points, const PolygonList& polygons, const std::string& name);

}
