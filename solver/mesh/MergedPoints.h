#pragma once
// Points that are one point, written several times.

#include "solver/mesh/TriangleMesh.h"

#include <vector>

namespace vesicle
{

struct MergedPoints
{
  std::vector<int> number; ///< of each point, that of the point it becomes
  std::vector<int> kept;   ///< of each point that there is then, the first that became it
};

/// Points nearer than `distance` (> 0) to one that was kept before become that one.
MergedPoints merged_points(const Points& points, double distance);

/// The points that were kept.
Points kept_points(const Points& points, const MergedPoints& merged);

}
