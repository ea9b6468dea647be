#pragma once
// The equilibrium of a scene or branch as a mesh file, and of a scene as what `vesicle run` leaves.

#include "apps/EquilibriumText.h"

#include "solver/scene/Scene.h"

#include <filesystem>

namespace vesicle
{

/// Writes the mesh, which stands for Loop's surface, and warns where it passes through itself. Throws
/// InputError, IoError.
void write_equilibrium(
  const EquilibriumReport& report, const TriangleMesh& mesh, const std::filesystem::path& file);

/// Downhill from the scene's start mesh; `mesh` is what it comes to. Throws InputError,
/// NumericalError, IoError.
EquilibriumReport equilibrium_of_scene(const Scene& scene, bool follow, TriangleMesh& mesh);

/// What `vesicle run` does with a scene of time.end = "equilibrium": NAME.vtu and summary.json, the
/// report, in a folder. Returns the exit code.
int run_to_equilibrium(
  const Scene& scene, const std::filesystem::path& folder, bool overwrite, bool quiet);

}
