#pragma once
// What a run takes at the least, before anything of it is built.

#include "solver/scene/Scene.h"

#include <filesystem>

namespace vesicle
{

struct Cost
{
  double memory = 0;       ///< bytes
  double frames = 0;       ///< 0: unknown, the run ends when it is steady
  double steps = 0;        ///< at least; 0: unknown
  double step_seconds = 0; ///< of a step on one core, roughly
  double seconds = 0;      ///< of `steps`
  double disk = 0;         ///< bytes of all frames, before compression
  double picture = 0;      ///< bytes while one picture of the movie is drawn
};

/// That the scene's shapes ask for, all vesicles together; those with a mesh file count as none.
double shape_triangles(const Scene& scene);

/// `triangles`: of all vesicles together, here and below. By models fitted to runs of 320 to 5,120 triangles (docs/performance.md).
Cost cost_of(const Scene& scene, double triangles);

struct Resources
{
  double memory = 0; ///< bytes that the machine has, or this process may have
  double disk = 0;   ///< bytes free where the run writes
};
Resources resources_for(const std::filesystem::path& folder);

/// Throws InputError naming the scene's file, with the number and the keys that would change it.
void require_affordable(const Scene& scene, double triangles, const Resources& available);
/// Of this machine's memory alone, where nothing is written.
void require_memory(const Scene& scene, double triangles);

}
