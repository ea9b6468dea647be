#pragma once
// Directions at the nodes of a surface: along its normal, and along the surface itself.

#include "solver/mesh/TriangleMesh.h"

namespace vesicle
{

/// Three orthonormal vectors at every node, one after the other: N by 9.
using NodeFrames = Eigen::Matrix<double, Eigen::Dynamic, 9, Eigen::RowMajor>;

/// The unit normals and two tangents each.
NodeFrames frames_along(const Points& normals);

}
