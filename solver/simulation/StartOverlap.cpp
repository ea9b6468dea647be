#include "solver/simulation/StartOverlap.h"

#include "solver/mesh/BoundingBox.h"
#include "solver/mesh/JoinedMesh.h"
#include "solver/mesh/SelfCrossing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vesicle
{
namespace
{

/// Of surfaces that don't cross each other one point tells.
std::optional<Overlap> find_nested(const std::vector<TriangleMesh>& meshes)
{
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const TriangleMesh& mesh : meshes)
    boxes.push_back(bounding_box(mesh.points));
  for (std::size_t inner = 0; inner < meshes.size(); ++inner)
    for (std::size_t outer = 0; outer < meshes.size(); ++outer)
      if (const Vector3 point = meshes[inner].points.row(0);
          outer != inner && boxes[outer].contains(boxes[inner]) && encloses(meshes[outer], point))
        return Overlap{ std::min(inner, outer), std::max(inner, outer), true, point };
  return {};
}

}

// The solid angle: A. van Oosterom, J. Strackee, IEEE Trans. Biomed. Eng. 30 (1983) 125.
bool encloses(const TriangleMesh& mesh, const Vector3& point)
{
  double angle = 0;
  for (int t = 0; t < mesh.triangles.rows(); ++t)
  {
    auto [a, b, c] = corners(mesh, t);
    a -= point;
    b -= point;
    c -= point;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    angle += 2 *
      std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return angle > 2 * std::numbers::pi;
}

std::optional<Overlap> find_overlap(const std::vector<TriangleMesh>& meshes)
{
  if (meshes.size() < 2)
    return {};
  if (const auto crossing = find_self_crossing(joined(meshes)))
  {
    const std::size_t a = mesh_of_triangle(meshes, crossing->first),
                      b = mesh_of_triangle(meshes, crossing->second);
    return Overlap{ std::min(a, b), std::max(a, b), false, crossing->place };
  }
  return find_nested(meshes);
}

std::string to_text(const Overlap& o)
{
  return fmt::format("vesicles {} and {} {} near ({:.6g}, {:.6g}, {:.6g})", o.first, o.second,
    o.inside ? "are one inside of the other" : "overlap", o.place.x(), o.place.y(), o.place.z());
}

}
