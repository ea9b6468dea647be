#pragma once
// What `vesicle check` says of a scene.

#include "solver/mesh/MeshQuality.h"
#include "solver/scene/Scene.h"
#include "solver/simulation/Cost.h"
#include "solver/simulation/DimensionlessNumbers.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <optional>
#include <string>

namespace vesicle
{

struct SceneCheck
{
  std::filesystem::path folder; ///< that a run would write to
  std::size_t vesicles = 1;
  // Of the start meshes together, in the scene's units; area and volume are of the scene's surface. The
  // numbers below are the first vesicle's.
  Eigen::Index vertices = 0, triangles = 0;
  MeshQuality quality;
  double area = 0, volume = 0, reduced_volume = 0;
  double radius = 0;                           ///< r0
  double viscosity_ratio = 1;                  ///< inside over outside
  std::optional<DimensionlessNumbers> numbers; ///< not where there is no run in time
  Units units = Units::any;
  Cost cost;
  Resources available;
  std::string warnings; ///< what a run would say at its start, a line each; empty: nothing
};

/// Makes the start mesh and the system, solves nothing and writes nothing. Throws what a run would
/// throw at its start.
SceneCheck check_scene(const Scene& scene, const std::filesystem::path& folder);

std::string to_text(const SceneCheck& check);
nlohmann::ordered_json to_json(const SceneCheck& check);

}
