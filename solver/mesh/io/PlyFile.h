#pragma once
// PLY, the Stanford polygon files.

#include "solver/mesh/io/SurfaceFile.h"

#include <string>
#include <string_view>

namespace vesicle
{

/// Reads text and both binary kinds. Elements and properties may come in any order and of any type;
/// points and the faces' list vertex_indices (or vertex_index), or triangle strips, make the
/// surface, the other scalar properties of points and faces are kept as arrays: nx ny nz as
/// Normals, red green blue (alpha) as RGB (RGBA), s t or u v as TCoords, and name_0 name_1 … as
/// components of one. Other lists and elements are passed over. `name` stands for the file in
/// messages. Throws InputError with the line or byte.
SurfaceFile read_ply(std::string_view bytes, const std::string& name);

}
