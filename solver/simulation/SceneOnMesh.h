#pragma once
// What a scene is on the triangles of one mesh, for all shapes that they take.

#include "solver/dynamics/Evolution.h"
#include "solver/dynamics/StateReport.h"
#include "solver/scene/Scene.h"
#include "solver/simulation/MeshAdaptation.h"
#include "solver/simulation/Resolution.h"

#include <optional>

namespace vesicle
{

class SceneOnMesh
{
public:
  /// `start`: see system_of.
  SceneOnMesh(const Scene& scene, const Scales& scales, const Triangles& triangles, int points,
    const Points& start);

  const Triangles& triangles() const { return triangles_; }
  Evolution& evolution() { return evolution_; }
  const StateReport& report() const { return report_; }
  /// Made when it is first asked for.
  const Resolution& resolution();
  /// That of the last shape asked for is kept.
  const MeshFitness& fitness(const Points& points);

private:
  Triangles triangles_;
  int points_;
  bool bends_; ///< without bending a rough surface costs nothing
  Evolution evolution_;
  StateReport report_;
  std::optional<Resolution> resolution_;
  Points asked_;
  MeshFitness fitness_{};
};

}
