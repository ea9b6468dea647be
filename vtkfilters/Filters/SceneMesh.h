#pragma once
// The mesh that a scene starts from, also one that is in a file.

#include "VesicleFiltersModule.h"

#include "solver/scene/Scene.h"

#include <string>

namespace vesicle
{

/// In the scene's units, of its shape or of its mesh file; `notes` tells what was changed. Throws
/// InputError, IoError.
VESICLEFILTERS_EXPORT TriangleMesh start_mesh_of(const Scene& scene, std::string& notes);

}
