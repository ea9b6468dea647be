#pragma once
// PLY files with the arrays that they can hold.

#include "solver/mesh/io/SurfaceFile.h"

#include <string>
#include <vector>

namespace vesicle
{

struct PlyText
{
  std::string bytes;
  std::vector<std::string> lost; ///< names of arrays that aren't in it
};

/// Binary, little endian. Points are float if the surface says so, else double, so that nothing is
/// lost. Arrays of points and faces become scalar properties, named as read_ply() knows them:
/// three-component arrays of the role normals nx ny nz, bytes named RGB or RGBA red green blue
/// (alpha), other components name_0, name_1, …; blanks in names become underscores. Lost are
/// strings, 64-bit integers that a double can't hold, names that are there already, fields.
/// Polygons have up to 255 corners; their `cell` is a tuple of cell_data.
PlyText ply_text(const SurfaceFile& surface);

}
