#pragma once
// Meshes in plain text: .off (which VTK 9.1 neither reads nor writes) and .obj (which it writes
// with six digits).

#include "solver/mesh/TriangleMesh.h"

#include <string>

namespace vesicle
{

/// Reads OFF, also with colours after points or faces; polygons are cut into triangles from their
/// first corner. `name` stands for the file in messages. Throws InputError with the line.
TriangleMesh parse_off(const std::string& text, const std::string& name);

/// Reads the points and faces of a Wavefront OBJ file, nothing else; polygons as above.
TriangleMesh parse_obj(const std::string& text, const std::string& name);

std::string off_text(const TriangleMesh& mesh);
std::string obj_text(const TriangleMesh& mesh);

}
