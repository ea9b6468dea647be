#include "solver/mesh/BodyOrientation.h"

#include "solver/mesh/DisjointSets.h"
#include "solver/mesh/EdgeUses.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace vesicle
{
namespace
{

/// Triangles of the mesh by body; parts that are open, torn or inconsistent are none.
struct Parts
{
  std::vector<std::vector<int>> triangles;
};

Parts closed_parts(const TriangleMesh& mesh)
{
  const EdgeUses uses(mesh.triangles);
  const int count = static_cast<int>(mesh.triangles.rows());
  DisjointSets sets(count);
  for (int e = 0; e < uses.size(); ++e)
    for (const EdgeUse& use : uses[e])
      sets.unite(uses[e].front().triangle, use.triangle);
  std::vector<bool> is_body(count, true);
  for (int e = 0; e < uses.size(); ++e)
    if (uses[e].size() != 2 || uses[e][0].forward == uses[e][1].forward)
      is_body[sets.find(uses[e].front().triangle)] = false;
  std::vector<int> number(count, -1);
  Parts parts;
  for (int t = 0; t < count; ++t)
  {
    const int root = sets.find(t);
    if (!is_body[root])
      continue;
    if (number[root] < 0)
    {
      number[root] = static_cast<int>(parts.triangles.size());
      parts.triangles.emplace_back();
    }
    parts.triangles[number[root]].push_back(t);
  }
  return parts;
}

Body body_of(const TriangleMesh& mesh, const std::vector<int>& triangles)
{
  Body body;
  body.first_triangle = triangles[0];
  body.triangles = static_cast<int>(triangles.size());
  const Vector3 origin = mesh.points.row(mesh.triangles(triangles[0], 0));
  for (const int t : triangles)
  {
    const auto [a, b, c] = corners(mesh, t, origin);
    body.volume += a.dot(b.cross(c)) / 6;
    body.centre += (a + b + c) / (3. * body.triangles);
  }
  body.centre += origin;
  const double rounding = 1e-12 * std::cbrt(std::abs(body.volume));
  body.centre = body.centre.unaryExpr([=](double x) { return std::abs(x) < rounding ? 0 : x; });
  return body;
}

Eigen::AlignedBox3d box_of(const TriangleMesh& mesh, const std::vector<int>& triangles)
{
  Eigen::AlignedBox3d box;
  for (const int t : triangles)
    for (const Vector3& corner : corners(mesh, t))
      box.extend(corner);
  return box;
}

/// The sum of the solid angles under which the triangles are seen from x is ±4π inside, 0 outside
/// (A. van Oosterom, J. Strackee, IEEE Trans. Biomed. Eng. 30 (1983) 125).
bool contains(const TriangleMesh& mesh, const std::vector<int>& triangles, const Vector3& x)
{
  double angle = 0;
  for (const int t : triangles)
  {
    const auto [a, b, c] = corners(mesh, t, x);
    const double l = a.norm(), m = b.norm(), n = c.norm();
    angle +=
      2 * std::atan2(a.dot(b.cross(c)), l * m * n + a.dot(b) * n + b.dot(c) * l + c.dot(a) * m);
  }
  return std::abs(angle) > 2 * std::numbers::pi;
}

}

std::string to_text(const Body& body)
{
  return fmt::format("the body about ({:.6g}, {:.6g}, {:.6g}) of {} triangles", body.centre.x(),
    body.centre.y(), body.centre.z(), body.triangles);
}

BodyOrientation::BodyOrientation(const TriangleMesh& mesh) : triangles(mesh.triangles)
{
  const Parts parts = closed_parts(mesh);
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const auto& part : parts.triangles)
  {
    bodies.push_back(body_of(mesh, part));
    boxes.push_back(box_of(mesh, part));
  }
  // The outermost body around another is the one around it with the largest volume.
  for (std::size_t i = 0; i < bodies.size(); ++i)
  {
    const Vector3 corner = mesh.points.row(mesh.triangles(bodies[i].first_triangle, 0));
    for (std::size_t j = 0; j < bodies.size(); ++j)
    {
      const int outer = bodies[i].within;
      const double least = std::abs(outer < 0 ? bodies[i].volume : bodies[outer].volume);
      if (i != j && std::abs(bodies[j].volume) > least && boxes[j].contains(boxes[i]) &&
        contains(mesh, parts.triangles[j], corner))
        bodies[i].within = static_cast<int>(j);
    }
  }
  for (std::size_t i = 0; i < bodies.size(); ++i)
  {
    const Body& body = bodies[i];
    const double outermost = body.within < 0 ? body.volume : bodies[body.within].volume;
    turned.push_back(outermost < 0);
    inner_side.push_back(body.within >= 0 && (body.volume < 0) != turned.back());
    if (turned.back())
      for (const int t : parts.triangles[i])
        std::swap(triangles(t, 1), triangles(t, 2));
  }
}

bool BodyOrientation::any_turned() const
{
  return std::ranges::find(turned, true) != turned.end();
}

}
