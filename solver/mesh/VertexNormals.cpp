#include "solver/mesh/VertexNormals.h"

namespace vesicle
{

Points vertex_area_vectors(const Points& points, const Triangles& triangles)
{
  using Row3 = Eigen::RowVector3d;
  Points sums = Points::Zero(points.rows(), 3);
  for (const auto triangle : triangles.rowwise())
  {
    const Row3 to_b = points.row(triangle[1]) - points.row(triangle[0]);
    const Row3 to_c = points.row(triangle[2]) - points.row(triangle[0]);
    const Row3 area = to_b.cross(to_c) / 2;
    for (const int corner : triangle)
      sums.row(corner) += area;
  }
  return sums;
}

Points vertex_normals(const Points& points, const Triangles& triangles)
{
  Points normals = vertex_area_vectors(points, triangles);
  for (auto normal : normals.rowwise())
    normal.normalize();
  return normals;
}

}
