#include "solver/simulation/SceneOnMesh.h"

#include "solver/mesh/MeshQuality.h"
#include "solver/simulation/SystemOfScene.h"

namespace vesicle
{

static std::optional<double> fixed_step(const Scene& scene, const Scales& scales)
{
  if (scene.time.step)
    return *scene.time.step / scales.time();
  return {};
}

SceneOnMesh::SceneOnMesh(const Scene& scene, const Scales& scales, std::vector<VesicleMesh> meshes)
  : meshes_(std::move(meshes)), bends_(scene.membrane.bending_rigidity.has_value()),
    evolution_(system_of(scene, scales, meshes_), stepper_settings_of(scene), schedule_of(scene),
      scales.time(), fixed_step(scene, scales)),
    report_(evolution_.system(), scales, stepper_settings_of(scene).layer),
    resolutions_(meshes_.size())
{
}

const Resolution& SceneOnMesh::resolution(std::size_t vesicle)
{
  auto& own = resolutions_[vesicle];
  for (std::size_t other = 0; !own && other < vesicle; ++other)
    if (resolutions_[other] && same_triangles(triangles(other), triangles(vesicle)))
      own = resolutions_[other];
  if (!own)
    own = std::make_shared<const Resolution>(triangles(vesicle), meshes_[vesicle].nodes);
  return *own;
}

const MeshFitness& SceneOnMesh::fitness(const Points& points)
{
  if (asked_.rows() != points.rows() || asked_ != points)
  {
    fitness_ = { bends_ ? resolution(0).disagreement(points) : 0,
      mesh_quality({ points, triangles(0) }).min_angle_deg };
    asked_ = points;
  }
  return fitness_;
}

}
