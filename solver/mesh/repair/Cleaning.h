#pragma once
// Points and triangles that say something twice, or nothing.

#include "solver/mesh/TriangleMesh.h"

#include <vector>

namespace vesicle
{

/// Points nearer than `distance` (> 0) become one. Returns how many there are fewer.
int merge_points(TriangleMesh& mesh, double distance);

struct DroppedTriangles
{
  int without_area = 0; ///< a corner twice
  int doubled = 0;      ///< the same corners in the same sense as an earlier one
};
DroppedTriangles drop_idle_triangles(TriangleMesh& mesh);

/// Points that no triangle uses. Returns how many there were.
int drop_unused_points(TriangleMesh& mesh);

/// Keeps the triangles that are marked. Points stay.
void keep_triangles(TriangleMesh& mesh, const std::vector<bool>& kept);

}
