#pragma once
// How good the triangles are.

#include "solver/mesh/TriangleMesh.h"

namespace vesicle
{

struct MeshQuality
{
  double min_angle_deg = 0; ///< smallest corner angle, 60 at best
  double edge_ratio = 0;    ///< longest to shortest edge, 1 at best, infinite where points coincide
  double mean_edge = 0; ///< mean over the triangles' sides (an edge on an open border counts half)
  double min_edge = 0;
  int worst_triangle = -1; ///< where min_angle_deg is found

  double score() const { return min_angle_deg / edge_ratio; } ///< to rank meshes by, 60 at best
};
MeshQuality mesh_quality(const TriangleMesh& mesh);

}
