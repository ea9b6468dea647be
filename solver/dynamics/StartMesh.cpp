#include "solver/dynamics/Simulation.h"

#include "solver/dynamics/Discretization.h"

#include "solver/Errors.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace vesicle
{

namespace
{

constexpr double reduced_volume_tolerance = 1e-7;
constexpr int max_corrections = 12;

// Turns the shape's own z axis to where the scene wants it, or by the scene's rotation.
Eigen::Matrix3d orientation(const Scene::Vesicle& vesicle)
{
  if (vesicle.rotation)
  {
    const auto& [x, y, z, degrees] = *vesicle.rotation;
    return Eigen::AngleAxisd(degrees * std::numbers::pi / 180, Vector3(x, y, z).normalized())
      .toRotationMatrix();
  }
  return Eigen::Quaterniond::FromTwoVectors(Vector3::UnitZ(), vesicle.axis).toRotationMatrix();
}

}

SurfaceMeasures surface_measures(const Scene& scene, const TriangleMesh& mesh)
{
  if (scene.accuracy.basis == Scene::Basis::linear)
    return { flat_area(mesh), flat_volume(mesh) };
  const auto surface = make_loop_discretization(
    Model(), mesh.triangles, static_cast<int>(mesh.points.rows()), scene.accuracy.quadrature);
  const Constraints c = surface->constraints(mesh.points);
  return { c.area, c.volume };
}

// The shape whose surface, in the scene's basis, has the reduced volume asked for and r0 = 1.
// make_shape gives it to the flat triangles; for another basis the request is shifted until it
// holds there (the difference hardly depends on the request, so a few corrections do).
static TriangleMesh shape_on_surface(const Scene& scene)
{
  ShapeRequest request = scene.vesicle.shape;
  TriangleMesh mesh = make_shape(request);
  if (scene.accuracy.basis == Scene::Basis::linear)
    return mesh;
  SurfaceMeasures measures = surface_measures(scene, mesh);
  const auto wanted = scene.vesicle.shape.reduced_volume;
  const bool adjustable = wanted && request.kind != ShapeRequest::Kind::sphere;
  for (int sweep = 0; adjustable && sweep < max_corrections; ++sweep)
  {
    const double error = *wanted - reduced_volume(measures.area, measures.volume);
    if (std::abs(error) < reduced_volume_tolerance)
      break;
    *request.reduced_volume += error;
    mesh = make_shape(request);
    measures = surface_measures(scene, mesh);
  }
  mesh.points *= std::cbrt(4 * std::numbers::pi / (3 * measures.volume));
  return mesh;
}

TriangleMesh make_start_mesh(const Scene& scene)
{
  TriangleMesh mesh = shape_on_surface(scene);
  mesh.points =
    (scene.vesicle.radius * mesh.points * orientation(scene.vesicle).transpose()).eval();
  mesh.points.rowwise() += scene.vesicle.center.transpose();
  return mesh;
}

TriangleMesh place_start_mesh(const Scene& scene, TriangleMesh mesh)
{
  if (scene.vesicle.mesh_triangles)
    throw InputError(
      fmt::format("{}: vesicle.triangles with vesicle.file asks for a resampled mesh, "
                  "which this version can't do: leave the key out",
        scene.file.string()));
  const Vector3 center = volume_centroid(mesh);
  if (scene.vesicle.mesh_radius)
  {
    const double volume = std::abs(flat_volume(mesh));
    if (!(volume > 0))
      throw InputError(
        fmt::format("{}: the mesh encloses no volume, so vesicle.radius can't scale it",
          scene.vesicle.mesh_file ? scene.vesicle.mesh_file->string() : "mesh"));
    const double r0 = std::cbrt(3 * volume / (4 * std::numbers::pi));
    mesh.points =
      ((mesh.points.rowwise() - center.transpose()).eval() * (*scene.vesicle.mesh_radius / r0))
        .rowwise() +
      center.transpose();
  }
  if (scene.vesicle.rotation)
    mesh.points =
      (((mesh.points.rowwise() - center.transpose()) * orientation(scene.vesicle).transpose())
          .rowwise() +
        center.transpose())
        .eval();
  return mesh;
}

}
