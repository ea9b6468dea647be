#pragma once
// Whether what a scene has goes with its wall.

#include "solver/mesh/TriangleMesh.h"
#include "solver/scene/Scene.h"

#include <vector>

namespace vesicle
{

/// Throws InputError unless there is no wall, or the surface is smooth, the imposed flow is zero at the wall
/// (tried at points around the vesicles) and all vesicles are in front of it; `start` in the scene's units.
void require_fit_for_wall(const Scene& scene, const std::vector<TriangleMesh>& start);

}
