#pragma once
// gmsh's MSH files.

#include "solver/mesh/io/SurfaceFile.h"

#include <string>
#include <string_view>

namespace vesicle
{

/// Reads MSH 2 and 4.1, text and binary of both byte orders: the triangles, quadrilaterals and
/// triangles of second order, which become four each, and the nodes that they use, in the order of
/// the file. Points, lines and what fills a volume are left out, and so are nodes' data. `name` stands
/// for the file in messages. Throws InputError with the line or the byte.
SurfaceFile read_gmsh(std::string_view bytes, const std::string& name);

/// MSH 2.2 as text, each number in the shortest form that reads back to the same double.
std::string gmsh_text(const TriangleMesh& mesh);

}
