#pragma once
// The mesh that a scene starts from, also one that is in a file.

#include "VesicleFiltersModule.h"

#include "solver/scene/Scene.h"
#include "solver/simulation/StartMesh.h"

#include <string>
#include <vector>

namespace vesicle
{

/// Of each vesicle, in the scene's units, of its shape or of its mesh file, with notes on what was
/// changed. Throws InputError, IoError.
VESICLEFILTERS_EXPORT std::vector<StartMesh> start_meshes_of(const Scene& scene);
/// Of the first vesicle.
VESICLEFILTERS_EXPORT TriangleMesh start_mesh_of(const Scene& scene, std::string& notes);
/// The mesh that membrane.reference of the first vesicle names, where it names one. Throws InputError, IoError.
VESICLEFILTERS_EXPORT std::optional<TriangleMesh> reference_mesh_of(const Scene& scene);

}
