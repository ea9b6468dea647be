#pragma once
// The box around points.

#include "solver/mesh/TriangleMesh.h"

#include <Eigen/Geometry>

namespace vesicle
{

/// Empty without points.
inline Eigen::AlignedBox3d bounding_box(const Points& points)
{
  if (points.rows() == 0)
    return {};
  return { Vector3(points.colwise().minCoeff().transpose()),
    Vector3(points.colwise().maxCoeff().transpose()) };
}

}
