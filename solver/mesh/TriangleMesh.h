#pragma once
// A triangle mesh: points and the triangles between them.

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>

namespace vesicle
{

using Vector3 = Eigen::Vector3d;
/// #points by 3, one point a row.
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
/// #triangles by 3 indices into Points, counter-clockwise seen from outside.
using Triangles = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;

inline bool same_triangles(const Triangles& a, const Triangles& b)
{
  return a.rows() == b.rows() && a == b;
}

struct TriangleMesh
{
  Points points;
  Triangles triangles;
};

/// Of the points' box along the axes; 0 without points.
inline double box_diagonal(const Points& points)
{
  return points.rows() > 0 ? (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm() : 0;
}

/// The corners of triangle t, seen from `origin`.
inline std::array<Vector3, 3> corners(
  const TriangleMesh& mesh, int t, const Vector3& origin = Vector3::Zero())
{
  const auto corner = [&](int k) -> Vector3
  { return mesh.points.row(mesh.triangles(t, k)).transpose() - origin; };
  return { corner(0), corner(1), corner(2) };
}

}
