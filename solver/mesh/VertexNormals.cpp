#include "solver/mesh/VertexNormals.h"

namespace vesicle
{

// Each triangle's normal is computed at each of its corners: where its list begins has no say.
Points vertex_normals(const Points& points, const Triangles& triangles, NormalWeights weights)
{
  using Row3 = Eigen::RowVector3d;
  Points sum = Points::Zero(points.rows(), 3);
  for (const auto triangle : triangles.rowwise())
    for (int k = 0; k < 3; ++k)
    {
      const int i = triangle[k];
      const Row3 left = points.row(triangle[(k + 1) % 3]) - points.row(i);
      const Row3 right = points.row(triangle[(k + 2) % 3]) - points.row(i);
      const Row3 cross = left.cross(right);
      if (!(cross.squaredNorm() > 0))
        continue; // no area, no normal
      sum.row(i) += weights == NormalWeights::area
        ? Row3(cross / 6)
        : Row3(cross / (left.squaredNorm() * right.squaredNorm()));
    }
  for (auto normal : sum.rowwise())
    normal.normalize();
  return sum;
}

}
