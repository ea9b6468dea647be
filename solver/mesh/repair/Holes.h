#pragma once
// Holes of a surface, and small ones filled.

#include "solver/mesh/TriangleMesh.h"

#include <vector>

namespace vesicle
{

struct Hole
{
  std::vector<int>
    points;          ///< around it, as a triangle in it would run to face as its neighbours do
  double length = 0; ///< of its border
  /// `length` over the circumference √(πA) of the sphere that has the area of the connected surface
  /// around the hole: about the sine of the angle under which half of it is seen from the middle.
  double size = 0;
};

/// The borders of a mesh whose triangles form one fan at each point and agree on the orientation
/// (part_sheets, MeshInspection::reorientation).
std::vector<Hole> holes_of(const TriangleMesh& mesh);

/// Holes of up to that size are filled by triangles to their middle (one triangle where the hole is
/// one). Returns how many.
int fill_holes(TriangleMesh& mesh, double largest);

}
