#pragma once
// Going on with a run from its checkpoint.

#include "solver/scene/Scene.h"
#include "solver/state/RunFile.h"

#include <filesystem>

namespace vesicle
{

class Simulation;

/// Throws InputError naming what differs unless the checkpoint is of this scene and program; only
/// the end may be another (later than the checkpoint's state) and how pictures are made.
void require_same_scene(const Scene& scene, const RunFile& run, const std::filesystem::path& file);

/// Throws InputError unless the simulation has the checkpoint's mesh and size (a mesh file may have
/// changed since).
void require_same_mesh(
  Simulation& simulation, const RunFile& run, const std::filesystem::path& file);

}
