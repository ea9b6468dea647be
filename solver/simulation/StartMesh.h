#pragma once
// The mesh that a scene starts from.

#include "solver/scene/Scene.h"

#include <string>

namespace vesicle
{

/// The start mesh of a scene with a shape, in the scene's units, placed and oriented.
TriangleMesh make_start_mesh(const Scene& scene);

/// What that mesh doesn't hold of the shape, start_shape_warning().
std::string check_start_shape(const Scene& scene, const TriangleMesh& mesh);

/// Places a mesh that was read from the scene's mesh_file: resampled if the scene asks for a number
/// of triangles, scaled to the radius, rotated about its centroid, moved to the center. `notes` tells what was changed.
/// Throws InputError.
TriangleMesh place_start_mesh(const Scene& scene, TriangleMesh mesh, std::string& notes);

/// A warning if the mesh is too rough for the scene's basis; empty if it isn't.
std::string check_smoothness(const Scene& scene, const TriangleMesh& mesh);

}
