#pragma once
// Where a mesh went wrong.

#include "solver/mesh/TriangleMesh.h"

#include <string>
#include <vector>

namespace vesicle
{

struct GuiltyTriangles
{
  std::vector<int> triangles;      ///< ascending; empty where nothing stands out
  std::string why;                 ///< "triangles 4 and 17 cross near (0, 0, 1)"
  Vector3 place = Vector3::Zero(); ///< the middle of the first of them
};

/// Those that, of these, the first that there is: have corners that aren't finite; pass through each other;
/// are around the vertex that moved most from `before` (the same triangles, or none to compare with) beside
/// the others, if that is more than a third of a mean edge; have an angle below 5 degrees; or the one on
/// which the energy of Loop's surface is known worst.
GuiltyTriangles guilty_triangles(const TriangleMesh& mesh, const TriangleMesh& before);

}
