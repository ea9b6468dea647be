#include "solver/surface/NodeFrames.h"

#include <Eigen/Geometry>

namespace vesicle
{

NodeFrames frames_along(const Points& normals)
{
  NodeFrames frames(normals.rows(), 9);
  for (Eigen::Index i = 0; i < normals.rows(); ++i)
  {
    const Vector3 n = normals.row(i).transpose(), t = n.unitOrthogonal();
    frames.row(i) << n.transpose(), t.transpose(), n.cross(t).transpose();
  }
  return frames;
}

}
