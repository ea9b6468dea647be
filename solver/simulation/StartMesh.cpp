#include "solver/simulation/StartMesh.h"

#include "solver/simulation/Cost.h"
#include "solver/surface/StartShape.h"
#include "solver/surface/SurfaceMeasures.h"
#include "solver/surface/LoopEnergy.h"
#include "solver/mesh/MeshIntegrals.h"
#include "solver/mesh/Preparation.h"
#include "solver/mesh/remesh/Remesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vesicle
{

namespace
{

// A disagreement of the energy that makes a mesh too rough for a Loop surface.
constexpr double rough_energy = 0.01;

}

Eigen::Matrix3d orientation(const Scene::Vesicle& vesicle)
{
  if (vesicle.rotation)
  {
    const auto& [x, y, z, degrees] = *vesicle.rotation;
    return Eigen::AngleAxisd(degrees * std::numbers::pi / 180, Vector3(x, y, z).normalized())
      .toRotationMatrix();
  }
  return turn_z_to(vesicle.axis);
}

const TriangleMesh& StartShapes::of(const ShapeRequest& shape, SurfaceBasis basis)
{
  if (basis != basis_)
    made_.clear();
  basis_ = basis;
  const auto found =
    std::find_if(made_.begin(), made_.end(), [&](const auto& made) { return made.first == shape; });
  if (found != made_.end())
    return found->second;
  return made_.emplace_back(shape, make_start_shape(shape, basis)).second;
}

TriangleMesh make_start_mesh(const Scene& scene)
{
  StartShapes shapes;
  return make_start_mesh(scene, shapes);
}

TriangleMesh make_start_mesh(const Scene& scene, StartShapes& shapes)
{
  const Scene::Vesicle& vesicle = scene.vesicle;
  require_memory(scene, vesicle.shape.triangles);
  TriangleMesh mesh = shapes.of(vesicle.shape, scene.accuracy.basis);
  place(mesh, vesicle.radius, orientation(vesicle), vesicle.center);
  return mesh;
}

std::vector<StartMesh> make_start_meshes(const Scene& scene)
{
  StartShapes shapes;
  std::vector<StartMesh> meshes;
  for (std::size_t v = 0; v < scene.vesicles(); ++v)
  {
    const Scene own = scene.alone(v);
    TriangleMesh mesh = make_start_mesh(own, shapes);
    std::string notes = check_start_shape(own, mesh);
    meshes.push_back({ std::move(mesh), std::move(notes) });
  }
  return meshes;
}

std::string check_start_shape(const Scene& scene, const TriangleMesh& mesh)
{
  return start_shape_warning(scene.vesicle.shape, scene.accuracy.basis, mesh);
}

std::string check_smoothness(const Scene& scene, const TriangleMesh& mesh)
{
  if (scene.accuracy.basis == Scene::Basis::linear)
    return {};
  const double disagreement = loop_energy(mesh).disagreement();
  if (disagreement < rough_energy)
    return {};
  return fmt::format(
    "The mesh is rough, or too coarse for its tips and rims: the bending energy of its Loop "
    "surface is known to {:.0f}% only. Take more triangles (vesicle.triangles; with vesicle.file "
    "it is resampled then), or accuracy.preset = \"fast\".",
    100 * disagreement);
}

// New points and triangles on the surface of a mesh, and what that changed, in words.
static std::string resample_start_mesh(TriangleMesh& mesh, const std::string& name, int triangles)
{
  std::string notes = prepare_for_dynamics(mesh, name);
  Remeshed resampled = remesh(mesh, triangles);
  const RemeshReport& r = resampled.report;
  notes += fmt::format(
    "{}{}: resampled from {} to {} triangles; largest distance {:.1e} r0, area {:+.2e}, volume "
    "{:+.2e}, reduced volume {:.4f} (was {:.4f}), smallest angle {:.0f} degrees",
    notes.empty() ? "" : "\n", name, mesh.triangles.rows(), r.triangles, r.max_distance,
    r.area_error, r.volume_error, r.reduced_volume, r.input_reduced_volume,
    r.quality.min_angle_deg);
  mesh = std::move(resampled.mesh);
  return notes;
}

TriangleMesh place_start_mesh(const Scene& scene, TriangleMesh mesh, std::string& notes)
{
  const std::string name =
    scene.vesicle.mesh_file ? scene.vesicle.mesh_file->string() : std::string("mesh");
  require_memory(
    scene, static_cast<double>(scene.vesicle.mesh_triangles.value_or(mesh.triangles.rows())));
  if (scene.vesicle.mesh_triangles)
    notes = resample_start_mesh(mesh, name, *scene.vesicle.mesh_triangles);
  else
    notes = prepare_for_dynamics(mesh, name);
  const Vector3 center = volume_centroid(mesh);
  mesh.points.rowwise() -= center.transpose();
  if (scene.vesicle.mesh_radius)
  {
    const double volume = surface_measures(scene.accuracy.basis, mesh).volume;
    mesh.points *= *scene.vesicle.mesh_radius / equivalent_radius(volume);
  }
  if (scene.vesicle.rotation)
    mesh.points = (mesh.points * orientation(scene.vesicle).transpose()).eval();
  mesh.points.rowwise() += scene.vesicle.mesh_center.value_or(center).transpose();
  return mesh;
}

}
