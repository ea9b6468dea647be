#pragma once
// OFF, Geomview's object file format.

#include "solver/mesh/io/SurfaceFile.h"

#include <string>
#include <string_view>

namespace vesicle
{

/// Reads OFF and its relatives with normals, colours or texture coordinates after each point
/// (NOFF, COFF, STOFF and their combinations), line by line or free-form; colours after faces too.
/// Of all that the points and the faces are kept. `name` stands for the file in messages. Throws
/// InputError with the line, also for binary files and those of other dimensions (4OFF, nOFF).
SurfaceFile read_off(std::string_view text, const std::string& name);

/// Each number in the shortest form that reads back to the same double.
std::string off_text(const TriangleMesh& mesh);

}
