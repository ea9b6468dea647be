#include "SceneMesh.h"

#include "MeshConversion.h"
#include "MeshFiles.h"

#include "solver/simulation/StartMesh.h"

#include "vtkPolyData.h"

namespace vesicle
{

TriangleMesh start_mesh_of(const Scene& scene, std::string& notes)
{
  const auto& wanted = scene.vesicle;
  if (!wanted.mesh_file)
  {
    TriangleMesh mesh = make_start_mesh(scene);
    notes = check_start_shape(scene, mesh);
    return mesh;
  }
  auto surface = read_mesh(*wanted.mesh_file);
  if (wanted.mesh_merge)
  {
    surface = merged(surface, *wanted.mesh_merge);
  }
  return place_start_mesh(scene, to_mesh(surface), notes);
}

}
