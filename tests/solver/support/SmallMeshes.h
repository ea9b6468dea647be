#pragma once
// Small meshes with known properties and faults.

#include "solver/mesh/shapes/GeodesicSphere.h"
#include "tests/solver/support/TestMeshes.h"

#include <algorithm>
#include <initializer_list>

namespace vesicle::test
{

inline Triangles triangle_list(std::initializer_list<std::array<int, 3>> list)
{
  Triangles triangles(static_cast<int>(list.size()), 3);
  int t = 0;
  for (const auto& [a, b, c] : list)
    triangles.row(t++) << a, b, c;
  return triangles;
}

inline TriangleMesh sphere(int n = 4)
{
  return geodesic_sphere(n);
}

inline TriangleMesh moved(TriangleMesh mesh, const Vector3& by)
{
  mesh.points.rowwise() += by.transpose();
  return mesh;
}

/// The cube of side 2 about the origin, its faces cut along diagonals.
inline TriangleMesh cube()
{
  TriangleMesh mesh{ Points(8, 3), Triangles(12, 3) };
  for (int i = 0; i < 8; ++i)
    mesh.points.row(i) << (i & 1 ? 1 : -1), (i & 2 ? 1 : -1), (i & 4 ? 1 : -1);
  mesh.triangles = triangle_list({ { 0, 2, 3 }, { 0, 3, 1 }, { 4, 5, 7 }, { 4, 7, 6 }, { 0, 1, 5 },
    { 0, 5, 4 }, { 2, 6, 7 }, { 2, 7, 3 }, { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 }, { 1, 7, 5 } });
  return mesh;
}

/// Both meshes side by side in one.
inline TriangleMesh together(const TriangleMesh& left, const TriangleMesh& right)
{
  TriangleMesh both{ Points(left.points.rows() + right.points.rows(), 3),
    Triangles(left.triangles.rows() + right.triangles.rows(), 3) };
  both.points << left.points, right.points;
  both.triangles << left.triangles, right.triangles.array() + static_cast<int>(left.points.rows());
  return both;
}

/// Two spheres with one common point, number 0.
inline TriangleMesh bow_tie()
{
  const TriangleMesh left = sphere();
  const Vector3 touch = left.points.row(0);
  TriangleMesh right = left;
  right.points = -right.points;
  for (int t = 0; t < right.triangles.rows(); ++t)
    std::swap(right.triangles(t, 1), right.triangles(t, 2));
  TriangleMesh both = together(left, moved(right, 2 * touch));
  for (int& vertex : both.triangles.reshaped())
    vertex = vertex == left.points.rows() ? 0 : vertex;
  return both;
}

/// A torus of radii 2 and 0.7 in the x–y plane.
inline TriangleMesh torus()
{
  return torus(2, 0.7, 24, 10);
}

/// The projective plane on six points (half an icosahedron with opposite points identified): closed
/// and a manifold, but with one side only.
inline TriangleMesh projective_plane()
{
  return { sphere(1).points.topRows(6),
    triangle_list({ { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 }, { 0, 4, 5 }, { 0, 5, 1 }, { 1, 2, 4 },
      { 2, 3, 5 }, { 3, 4, 1 }, { 4, 5, 2 }, { 5, 1, 3 } }) };
}

inline TriangleMesh without_triangles(TriangleMesh mesh, std::initializer_list<int> removed)
{
  Triangles kept(mesh.triangles.rows() - static_cast<int>(removed.size()), 3);
  int next = 0;
  for (int t = 0; t < mesh.triangles.rows(); ++t)
    if (std::ranges::find(removed, t) == removed.end())
      kept.row(next++) = mesh.triangles.row(t);
  mesh.triangles = kept;
  return mesh;
}

inline TriangleMesh turned_over(TriangleMesh mesh, int first, int last)
{
  for (int t = first; t < last; ++t)
    std::swap(mesh.triangles(t, 1), mesh.triangles(t, 2));
  return mesh;
}

/// The same surface with its points and triangles in reverse order and each triangle begun
/// elsewhere.
inline TriangleMesh in_reverse_order(const TriangleMesh& mesh)
{
  const int last = static_cast<int>(mesh.points.rows()) - 1;
  TriangleMesh other{ mesh.points.colwise().reverse(), mesh.triangles.colwise().reverse() };
  for (int t = 0; t < other.triangles.rows(); ++t)
  {
    const Eigen::RowVector3i row = last - other.triangles.row(t).array();
    other.triangles.row(t) << row[t % 3], row[(t + 1) % 3], row[(t + 2) % 3];
  }
  return other;
}

}
