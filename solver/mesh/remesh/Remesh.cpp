#include "solver/mesh/remesh/Remesh.h"

#include "solver/Errors.h"
#include "solver/mesh/Connectivity.h"
#include "solver/mesh/MeshIntegrals.h"
#include "solver/mesh/TriangleTree.h"
#include "solver/mesh/remesh/IsotropicMesh.h"
#include "solver/mesh/remesh/ProjectedMesh.h"
#include "solver/mesh/remesh/SemiRegularMesh.h"
#include "solver/mesh/remesh/TriangleCount.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace vesicle
{

namespace
{
constexpr int most_triangles = 200'000; // about a gigabyte of work space
/// Of the input's vertices to the new triangles, in r0: the icosahedron's faces are 0.21 inside the
/// sphere through its corners.
constexpr double allowed_distance = 0.3;
/// Of the volume (the icosahedron: 0.4): a thin body could be lost within that distance.
constexpr double accepted_loss = 0.5;
constexpr double accepted_angle = 10; // degrees; dynamics are known to fail near 5

struct Distances
{
  double largest = 0;
  double sum_of_squares = 0;
};

Distances distances(const Points& points, const TriangleMesh& mesh)
{
  const TriangleTree tree(mesh);
  Distances result;
  for (const Vector3 x : points.rowwise())
  {
    const double squared = tree.nearest(x).squared_distance;
    result.largest = std::max(result.largest, std::sqrt(squared));
    result.sum_of_squares += squared;
  }
  return result;
}

/// Scaled to r0 = 1 about the centroid: lengths have the same size whatever the units, and a mesh
/// far from the origin loses no digits.
class Normalisation
{
public:
  explicit Normalisation(const TriangleMesh& mesh)
    : centre_(volume_centroid(mesh)), r0_(std::cbrt(3 * flat_volume(mesh) / (4 * std::numbers::pi)))
  {
  }
  TriangleMesh normalised(TriangleMesh mesh) const
  {
    mesh.points = ((mesh.points.rowwise() - centre_.transpose()) / r0_).eval();
    return mesh;
  }
  TriangleMesh restored(TriangleMesh mesh) const
  {
    mesh.points = ((mesh.points * r0_).rowwise() + centre_.transpose()).eval();
    return mesh;
  }

private:
  Vector3 centre_;
  double r0_;
};

void check_request(int triangles)
{
  if (triangles < fewest_triangles || triangles > most_triangles)
  {
    throw InputError(fmt::format("triangles = {}: a mesh can be resampled to {} to {} triangles",
      triangles, fewest_triangles, most_triangles));
  }
}

TriangleMesh new_mesh(const TriangleMesh& input, int triangles)
{
  const SurfaceSmoother smoother(input, triangles);
  std::optional<EditableMesh> mesh = projected_mesh(smoother, triangles);
  if (!mesh)
    mesh = semi_regular_mesh(smoother, triangles);
  if (!mesh)
    mesh = isotropic_mesh(smoother, triangles, MeshGoal::triangle_shape);
  if (!mesh)
  {
    throw InputError(fmt::format(
      "the surface can't be meshed with {} triangles: ask for more triangles", triangles));
  }
  return { std::move(mesh->points), std::move(mesh->triangles) };
}

/// `distance`: of the input's points to the new triangles.
void check_result(const RemeshReport& report, double distance)
{
  const auto beginning = [&]
  { return fmt::format("{} triangles are too few for this mesh: ", report.triangles); };
  if (!(distance <= allowed_distance) || !(report.volume_error >= -accepted_loss))
  {
    throw InputError(beginning() +
      fmt::format("its points would be up to {:.2f} radii off the new surface (allowed: {}), which "
                  "would have {:.0f}% of its volume; raise triangles",
        distance, allowed_distance, 100 * (1 + report.volume_error)));
  }
  if (!(report.quality.min_angle_deg >= accepted_angle))
  {
    throw InputError(beginning() +
      fmt::format("the smallest angle would be {:.1f}° (allowed: {}°) and its points up to {:.2f} "
                  "radii off the new surface; raise triangles",
        report.quality.min_angle_deg, accepted_angle, distance));
  }
}

/// Of meshes normalised by the input's r0.
RemeshReport report_on(const TriangleMesh& input, const TriangleMesh& mesh)
{
  RemeshReport report;
  report.triangles = static_cast<int>(mesh.triangles.rows());
  const Distances there = distances(input.points, mesh), back = distances(mesh.points, input);
  report.max_distance = std::max(there.largest, back.largest);
  report.rms_distance = std::sqrt((there.sum_of_squares + back.sum_of_squares) /
    static_cast<double>(input.points.rows() + mesh.points.rows()));
  const double input_area = flat_area(input), input_volume = flat_volume(input);
  const double area = flat_area(mesh), volume = flat_volume(mesh);
  report.area_error = area / input_area - 1;
  report.volume_error = volume / input_volume - 1;
  report.input_reduced_volume = reduced_volume(input_area, input_volume);
  report.reduced_volume = reduced_volume(area, volume);
  report.quality = mesh_quality(mesh);
  check_result(report, there.largest);
  const int points = static_cast<int>(mesh.points.rows());
  const Connectivity connectivity(mesh.triangles, points);
  report.least_valence = points;
  for (int i = 0; i < points; ++i)
  {
    const int valence = connectivity.vertex_neighbours.size(i);
    report.least_valence = std::min(report.least_valence, valence);
    report.largest_valence = std::max(report.largest_valence, valence);
  }
  return report;
}
}

Remeshed remesh(const TriangleMesh& input, int triangles)
{
  check_request(triangles);
  const Normalisation normalisation(input);
  const TriangleMesh source = normalisation.normalised(input);
  const TriangleMesh mesh = new_mesh(source, triangles + triangles % 2);
  Remeshed result{ normalisation.restored(mesh), report_on(source, mesh) };
  result.report.quality = mesh_quality(result.mesh);
  return result;
}

}
