#include "solver/dynamics/Simulation.h"

#include "solver/Errors.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace vesicle
{

namespace
{

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

TriangleMesh make_start_mesh(const Scene& scene)
{
  TriangleMesh mesh = make_shape(scene.vesicle.shape);
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
