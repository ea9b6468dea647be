#pragma once
// A surface that was cut into pieces, each with cells of its neighbours around it.

#include "solver/mesh/io/SurfaceFile.h"

#include <string>
#include <vector>

namespace vesicle
{

/// The bits of arrays named vtkGhostType that matter here, as in vtkDataSetAttributes.
constexpr const char* ghost_array = "vtkGhostType";
constexpr int duplicate_cell = 1;
constexpr int hidden_cell = 32;
constexpr int duplicate_point = 1;

/// One piece is left as it is. Of several, cells that are marked as another piece's (or hidden) are
/// left out, and points of different pieces at the same coordinates become one, with the values of
/// the piece that it belongs to; arrays that not all pieces have are left out. Throws InputError
/// "name: …".
SurfaceFile joined(std::vector<SurfaceFile> pieces, const std::string& name);

}
