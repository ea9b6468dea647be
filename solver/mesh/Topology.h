#pragma once
// What kind of surface a mesh is.

#include "solver/mesh/TriangleMesh.h"

namespace vesicle
{

struct Topology
{
  bool closed = false;   ///< every edge has two triangles or more
  bool manifold = false; ///< no edge has more than two; the triangles at a vertex form one fan
  bool oriented = false; ///< neighbouring triangles agree on the orientation
  int components = 0;    ///< edge-connected, of vertices that a triangle uses
  int genus = 0;         ///< of a closed, manifold mesh, summed over the components; otherwise 0
};
Topology topology(const TriangleMesh& mesh);

}
