#pragma once
// Charts of a run's diagnostics against time.

#include "apps/CsvFile.h"

#include "solver/scene/Scene.h"

#include <filesystem>
#include <vector>

namespace vesicle
{

/// Writes one PNG a subject into `folder`: those that say something of this scene (energy where there
/// is bending, speed under gravity, inclination in a flow, tension, drift). Throws IoError.
void write_run_plots(
  const Scene& scene, const std::vector<Row>& rows, const std::filesystem::path& folder);

}
