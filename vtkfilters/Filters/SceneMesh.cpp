#include "SceneMesh.h"

#include "MeshConversion.h"
#include "MeshFiles.h"

#include "solver/simulation/StartMesh.h"

#include "vtkPolyData.h"

namespace vesicle
{

std::optional<TriangleMesh> reference_mesh_of(const Scene& scene)
{
  if (scene.membrane.reference != Scene::Membrane::Reference::file)
  {
    return std::nullopt;
  }
  return to_mesh(read_mesh(*scene.membrane.reference_file));
}

static StartMesh start_mesh_of(const Scene& scene, StartShapes& shapes)
{
  const auto& wanted = scene.vesicle;
  StartMesh start;
  start.reference = reference_mesh_of(scene);
  if (!wanted.mesh_file)
  {
    start.mesh = make_start_mesh(scene, shapes);
    start.notes = check_start_shape(scene, start.mesh);
    return start;
  }
  auto surface = read_mesh(*wanted.mesh_file);
  if (wanted.mesh_merge)
  {
    surface = merged(surface, *wanted.mesh_merge);
  }
  start.mesh = place_start_mesh(scene, to_mesh(surface), start.notes);
  return start;
}

std::vector<StartMesh> start_meshes_of(const Scene& scene)
{
  StartShapes shapes;
  std::vector<StartMesh> meshes;
  for (std::size_t v = 0; v < scene.vesicles(); ++v)
  {
    meshes.push_back(start_mesh_of(scene.alone(v), shapes));
  }
  return meshes;
}

TriangleMesh start_mesh_of(const Scene& scene, std::string& notes)
{
  StartShapes shapes;
  StartMesh start = start_mesh_of(scene.alone(0), shapes);
  notes = start.notes;
  return std::move(start.mesh);
}

}
