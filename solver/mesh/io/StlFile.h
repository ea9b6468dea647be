#pragma once
// STL, triangles without connectivity.

#include "solver/mesh/io/SurfaceFile.h"

#include <string>
#include <string_view>

namespace vesicle
{

/// Reads binary files (of exactly the length that their header announces; the word "solid" decides
/// nothing) and text of one or several solids, whose coordinates keep double precision. Corners of
/// the same coordinates become one point. `name` stands for the file in messages. Throws InputError
/// with the line of a text, or the lengths.
SurfaceFile read_stl(std::string_view bytes, const std::string& name);

/// Binary, which holds single precision.
std::string stl_bytes(const TriangleMesh& mesh);

}
