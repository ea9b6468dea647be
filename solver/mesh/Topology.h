#pragma once
// What kind of surface a mesh is.

#include "solver/mesh/TriangleMesh.h"

#include <optional>

namespace vesicle
{

struct Topology
{
  bool closed = false;   ///< every edge has two triangles or more
  bool manifold = false; ///< no edge has more than two; the triangles at a vertex form one fan
  bool oriented = false; ///< neighbouring triangles agree on the orientation
  int components = 0;    ///< edge-connected, of vertices that a triangle uses
  /// Of a closed, manifold, oriented mesh, summed over the components; others have none.
  std::optional<int> genus;
};
Topology topology(const TriangleMesh& mesh);

}
