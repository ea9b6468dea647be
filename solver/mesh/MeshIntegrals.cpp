// Volumes are summed seen from a point of the mesh, so that a mesh far from the origin loses no
// digits.

#include "solver/mesh/MeshIntegrals.h"

#include "solver/Errors.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace vesicle
{

namespace
{
Vector3 reference_point(const TriangleMesh& mesh)
{
  return mesh.triangles.rows() > 0 ? Vector3(mesh.points.row(mesh.triangles(0, 0)))
                                   : Vector3::Zero();
}
}

double flat_area(const TriangleMesh& mesh)
{
  double area = 0;
  for (int t = 0; t < mesh.triangles.rows(); ++t)
  {
    const auto [a, b, c] = corners(mesh, t);
    area += 0.5 * (b - a).cross(c - a).norm();
  }
  return area;
}

// V = Σ a · (b × c)/6, the signed tetrahedra over the triangles.
double flat_volume(const TriangleMesh& mesh)
{
  const Vector3 origin = reference_point(mesh);
  double volume = 0;
  for (int t = 0; t < mesh.triangles.rows(); ++t)
  {
    const auto [a, b, c] = corners(mesh, t, origin);
    volume += a.dot(b.cross(c)) / 6;
  }
  return volume;
}

// Each tetrahedron's centroid is (0 + a + b + c)/4.
Vector3 volume_centroid(const TriangleMesh& mesh)
{
  const Vector3 origin = reference_point(mesh);
  double volume = 0;
  Vector3 moment = Vector3::Zero();
  for (int t = 0; t < mesh.triangles.rows(); ++t)
  {
    const auto [a, b, c] = corners(mesh, t, origin);
    const double tetrahedron = a.dot(b.cross(c)) / 6;
    volume += tetrahedron;
    moment += tetrahedron * (a + b + c) / 4;
  }
  Vector3 centroid = origin + moment / volume;
  if (!centroid.allFinite())
  {
    throw InputError("the mesh encloses no volume, so that its volume has no centroid: a closed "
                     "mesh is needed");
  }
  return centroid;
}

double reduced_volume(double area, double volume)
{
  if (!(area > 0) || !std::isfinite(area) || !std::isfinite(volume))
  {
    throw InputError(fmt::format(
      "the reduced volume needs a positive area: area = {:.6g}, volume = {:.6g}", area, volume));
  }
  return 6 * std::sqrt(std::numbers::pi) * volume / std::pow(area, 1.5);
}

double flat_reduced_volume(const TriangleMesh& mesh)
{
  return reduced_volume(flat_area(mesh), flat_volume(mesh));
}

}
