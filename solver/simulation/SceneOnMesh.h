#pragma once
// What a scene is on the triangles of its vesicles' meshes, for all shapes that they take.

#include "solver/dynamics/Evolution.h"
#include "solver/dynamics/StateReport.h"
#include "solver/scene/Scene.h"
#include "solver/simulation/MeshAdaptation.h"
#include "solver/simulation/Resolution.h"
#include "solver/simulation/SystemOfScene.h"

#include <memory>
#include <vector>

namespace vesicle
{

class SceneOnMesh
{
public:
  SceneOnMesh(const Scene& scene, const Scales& scales, std::vector<VesicleMesh> meshes);

  /// Of a vesicle, here and below.
  const Triangles& triangles(std::size_t vesicle) const { return meshes_[vesicle].triangles; }
  Evolution& evolution() { return evolution_; }
  const StateReport& report() const { return report_; }
  /// Made when it is first asked for, once for equal meshes.
  const Resolution& resolution(std::size_t vesicle);
  /// Of the first vesicle; that of the last shape asked for is kept.
  const MeshFitness& fitness(const Points& points);

private:
  std::vector<VesicleMesh> meshes_;
  bool bends_; ///< without bending a rough surface costs nothing
  Evolution evolution_;
  StateReport report_;
  std::vector<std::shared_ptr<const Resolution>> resolutions_;
  Points asked_;
  MeshFitness fitness_{};
};

}
