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

SceneOnMesh::SceneOnMesh(const Scene& scene, const Scales& scales, const Triangles& triangles,
  int points, const Points& start)
  : triangles_(triangles), points_(points), bends_(scene.membrane.bending_rigidity.has_value()),
    evolution_(system_of(scene, scales, triangles, points, start), stepper_settings_of(scene),
      schedule_of(scene), scales.time(), fixed_step(scene, scales)),
    report_(evolution_.system(), scales)
{
}

const Resolution& SceneOnMesh::resolution()
{
  if (!resolution_)
    resolution_.emplace(triangles_, points_);
  return *resolution_;
}

const MeshFitness& SceneOnMesh::fitness(const Points& points)
{
  if (asked_.rows() != points.rows() || asked_ != points)
  {
    fitness_ = { bends_ ? resolution().disagreement(points) : 0,
      mesh_quality({ points, triangles_ }).min_angle_deg };
    asked_ = points;
  }
  return fitness_;
}

}
