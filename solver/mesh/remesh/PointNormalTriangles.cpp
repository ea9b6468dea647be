#include "solver/mesh/remesh/PointNormalTriangles.h"

#include "solver/mesh/remesh/FittedNormals.h"

#include <algorithm>

namespace vesicle
{

PointNormalTriangles::PointNormalTriangles(const TriangleMesh& mesh)
  : mesh_(mesh), normals_(fitted_normals(mesh))
{
}

double PointNormalTriangles::longest_side(int patch) const
{
  double longest = 0;
  for (int k = 0; k < 3; ++k)
  {
    const int i = mesh_.triangles(patch, k), j = mesh_.triangles(patch, (k + 1) % 3);
    longest = std::max(longest, (mesh_.points.row(i) - mesh_.points.row(j)).norm());
  }
  return longest;
}

/// The cubic with control points at the corners, two an edge in the corners' tangent planes, and
/// one in the middle so placed that quadratics are reproduced (Vlachos et al., section 3.1); the
/// normal is interpolated linearly.
PointWithNormal PointNormalTriangles::point(int patch, const Vector3& weights) const
{
  Vector3 position = Vector3::Zero(), normal = Vector3::Zero();
  Vector3 corners = Vector3::Zero(), edges = Vector3::Zero();
  for (int k = 0; k < 3; ++k)
  {
    const int i = mesh_.triangles(patch, k);
    const Vector3 x = mesh_.points.row(i);
    const Vector3 n = normals_.row(i);
    const double w = weights[k];
    normal += w * n;
    corners += x / 3;
    position += w * w * w * x;
    for (const int other : { (k + 1) % 3, (k + 2) % 3 })
    {
      const Vector3 y = mesh_.points.row(mesh_.triangles(patch, other));
      const Vector3 control = (2 * x + y - (y - x).dot(n) * n) / 3;
      edges += control / 6;
      position += 3 * w * w * weights[other] * control;
    }
  }
  position += 6 * weights.prod() * (edges + (edges - corners) / 2);
  return { position, normal.normalized() };
}

}
