#include "solver/mesh/SelfCrossing.h"

#include "solver/mesh/TriangleTree.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vesicle
{
namespace
{

using Corners = std::array<Vector3, 3>;

/// By which a point must be past a triangle's plane, of the longest side: less may be an accident
/// of rounded coordinates.
constexpr double least_depth = 1e-8;
/// Of the determinant's terms: J. R. Shewchuk, Adaptive precision floating-point arithmetic, Discrete
/// Comput. Geom. 18 (1997) 305, has (7 + 56 ε) ε for what is computed below.
constexpr double rounding = 8 * 1.1102230246251565e-16;

/// Six times the volume of the tetrahedron, 0 where its sign may be rounding.
double certain_volume(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  const Vector3 x = a - d, y = b - d, z = c - d;
  const double volume = x.dot(y.cross(z));
  const auto larger_cross = [](const Vector3& p, const Vector3& q) -> Vector3
  {
    const Vector3 l = p.cwiseAbs(), r = q.cwiseAbs();
    return { l.y() * r.z() + l.z() * r.y(), l.z() * r.x() + l.x() * r.z(),
      l.x() * r.y() + l.y() * r.x() };
  };
  const double terms = x.cwiseAbs().dot(larger_cross(y, z));
  return std::abs(volume) > rounding * terms ? volume : 0;
}

/// Where the segment from p to q goes through the inside of the triangle.
std::optional<Vector3> pierced(const Vector3& p, const Vector3& q, const Corners& t)
{
  const double from = certain_volume(t[0], t[1], t[2], p);
  const double to = certain_volume(t[0], t[1], t[2], q);
  if (!(from * to < 0))
    return {};
  const double side = certain_volume(p, q, t[0], t[1]);
  if (side == 0 || !(side * certain_volume(p, q, t[1], t[2]) > 0) ||
    !(side * certain_volume(p, q, t[2], t[0]) > 0))
    return {};
  const double twice_area = (t[1] - t[0]).cross(t[2] - t[0]).norm();
  const double longest =
    std::max({ (t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm(), (q - p).norm() });
  if (std::min(std::abs(from), std::abs(to)) <= least_depth * longest * twice_area)
    return {};
  return p + (q - p) * (from / (from - to));
}

bool uses(const TriangleMesh& mesh, int triangle, int vertex)
{
  const auto row = mesh.triangles.row(triangle);
  return row[0] == vertex || row[1] == vertex || row[2] == vertex;
}

int shared_corners(const TriangleMesh& mesh, int i, int j)
{
  const auto row = mesh.triangles.row(i);
  return uses(mesh, j, row[0]) + uses(mesh, j, row[1]) + uses(mesh, j, row[2]);
}

/// Where a side of i, or a median, goes through j. The medians find crossings of regular meshes,
/// whose sides often meet exactly in sides or corners; what ends in a common corner goes through
/// nothing.
std::optional<Vector3> goes_through(const TriangleMesh& mesh, int i, int j)
{
  const Corners of_i = corners(mesh, i), of_j = corners(mesh, j);
  for (int k = 0; k < 3; ++k)
  {
    const Vector3 &a = of_i[k], &b = of_i[(k + 1) % 3], &c = of_i[(k + 2) % 3];
    auto place = pierced(a, b, of_j);
    if (!place)
      place = pierced(a, (b + c) / 2, of_j);
    if (place)
      return place;
  }
  return {};
}

}

std::optional<Crossing> find_self_crossing(const TriangleMesh& mesh)
{
  if (mesh.triangles.rows() < 2)
    return {};
  std::optional<Crossing> found;
  TriangleTree(mesh).visit_overlaps(
    [&](int i, int j)
    {
      if (shared_corners(mesh, i, j) > 1) // folded onto each other at most
        return false;
      auto place = goes_through(mesh, i, j);
      if (!place)
        place = goes_through(mesh, j, i);
      if (place)
        found = Crossing{ std::min(i, j), std::max(i, j), *place };
      return place.has_value();
    });
  return found;
}

std::string to_text(const Crossing& crossing)
{
  return fmt::format("triangles {} and {} cross near ({:.6g}, {:.6g}, {:.6g})", crossing.first,
    crossing.second, crossing.place.x(), crossing.place.y(), crossing.place.z());
}

}
