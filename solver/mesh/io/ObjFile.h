#pragma once
// OBJ, Wavefront's object files.

#include "solver/mesh/io/SurfaceFile.h"

#include <string>
#include <string_view>

namespace vesicle
{

/// Reads the points and faces of all objects and groups as one surface; colours, where all points
/// have one behind their coordinates, as the point array RGB (0 to 1 in most files); normals, texture
/// and materials are left out. Corners count from 1, or back from the last point (−1). `name`
/// stands for the file in messages. Throws InputError with the line or the face.
SurfaceFile read_obj(std::string_view text, const std::string& name);

/// Each number in the shortest form that reads back to the same double. `normals`, `colours` (0 to 1):
/// none, or one a point.
std::string obj_text(
  const TriangleMesh& mesh, const Points& normals = {}, const Points& colours = {});

}
