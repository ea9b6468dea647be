#pragma once
// VTK's legacy files, .vtk.

#include "solver/mesh/io/GridFile.h"

#include <string>
#include <string_view>

namespace vesicle
{

/// Reads versions 1 to 5.1, text and binary, POLYDATA and UNSTRUCTURED_GRID with all attributes and
/// fields; colour tables are passed over. `name` stands for the file in messages. Throws InputError
/// with the line (of a binary file: counted by the line feeds outside its numbers), also for other
/// data sets and cells that aren't flat polygons.
SurfaceFile read_legacy_vtk(std::string_view bytes, const std::string& name);

/// The same of STRUCTURED_POINTS, RECTILINEAR_GRID, STRUCTURED_GRID and UNSTRUCTURED_GRID.
GridFile read_legacy_vtk_grid(std::string_view bytes, const std::string& name);

}
