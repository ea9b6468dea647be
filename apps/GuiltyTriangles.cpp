#include "apps/GuiltyTriangles.h"

#include "solver/Errors.h"
#include "solver/mesh/MeshQuality.h"
#include "solver/mesh/SelfCrossing.h"
#include "solver/surface/LoopEnergy.h"

#include <fmt/format.h>

#include <cmath>

namespace vesicle
{
namespace
{

constexpr double far_in_edges = 1. / 3, small_angle_deg = 5;

Vector3 middle(const TriangleMesh& mesh, int triangle)
{
  Vector3 sum = Vector3::Zero();
  for (int k = 0; k < 3; ++k)
    sum += mesh.points.row(mesh.triangles(triangle, k)).transpose() / 3;
  return sum;
}

template<class Test>
std::vector<int> triangles_where(const TriangleMesh& mesh, Test&& test)
{
  std::vector<int> found;
  for (int t = 0; t < mesh.triangles.rows(); ++t)
    if (test(t))
      found.push_back(t);
  return found;
}

/// With a corner that the test holds for.
template<class Test>
std::vector<int> triangles_at(const TriangleMesh& mesh, Test&& test)
{
  return triangles_where(mesh,
    [&](int t)
    {
      const auto corners = mesh.triangles.row(t);
      return test(corners[0]) || test(corners[1]) || test(corners[2]);
    });
}

double smallest_angle_deg(const TriangleMesh& mesh, int triangle)
{
  TriangleMesh one{ Points(3, 3), Triangles(1, 3) };
  for (int k = 0; k < 3; ++k)
  {
    one.points.row(k) = mesh.points.row(mesh.triangles(triangle, k));
    one.triangles(0, k) = k;
  }
  return mesh_quality(one).min_angle_deg;
}

GuiltyTriangles moved_far(const TriangleMesh& mesh, const TriangleMesh& before)
{
  if (before.points.rows() != mesh.points.rows())
    return {};
  Points moved = mesh.points - before.points;
  moved.rowwise() -= moved.colwise().mean().eval();
  Eigen::Index vertex = 0;
  const double edges = moved.rowwise().norm().maxCoeff(&vertex) / mesh_quality(before).mean_edge;
  if (!(edges > far_in_edges))
    return {};
  return { triangles_at(mesh, [&](int corner) { return corner == vertex; }),
    fmt::format("vertex {} moves by {:.2g} edges beside the others", vertex, edges) };
}

GuiltyTriangles thin(const TriangleMesh& mesh)
{
  const MeshQuality quality = mesh_quality(mesh);
  if (!(quality.min_angle_deg < small_angle_deg))
    return {};
  return { triangles_where(
             mesh, [&](int t) { return smallest_angle_deg(mesh, t) < small_angle_deg; }),
    fmt::format("triangle {} has an angle of {:.2g} degrees", quality.worst_triangle,
      quality.min_angle_deg) };
}

GuiltyTriangles badly_known(const TriangleMesh& mesh)
try
{
  const LoopEnergy energy = loop_energy(mesh);
  int nearest = 0;
  for (int t = 1; t < mesh.triangles.rows(); ++t)
    if ((middle(mesh, t) - energy.worst).norm() < (middle(mesh, nearest) - energy.worst).norm())
      nearest = t;
  return { { nearest },
    fmt::format("the bending energy is known to {:.2g}%, worst on triangle {}",
      100 * energy.disagreement(), nearest) };
}
catch (const InputError&) // triangles that carry no smooth surface
{
  return {};
}

GuiltyTriangles first_found(const TriangleMesh& mesh, const TriangleMesh& before)
{
  if (!mesh.points.allFinite())
    return { triangles_at(mesh, [&](int corner) { return !mesh.points.row(corner).allFinite(); }),
      "positions are not finite" };
  if (const auto crossing = find_self_crossing(mesh))
    return { { crossing->first, crossing->second }, to_text(*crossing) };
  for (const auto& found : { moved_far(mesh, before), thin(mesh) })
    if (!found.triangles.empty())
      return found;
  return badly_known(mesh);
}

}

GuiltyTriangles guilty_triangles(const TriangleMesh& mesh, const TriangleMesh& before)
{
  GuiltyTriangles guilty = first_found(mesh, before);
  if (!guilty.triangles.empty() && mesh.points.allFinite())
    guilty.place = middle(mesh, guilty.triangles.front());
  return guilty;
}

}
