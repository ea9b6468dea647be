#pragma once
// VTK's XML files of grids: .vti, .vtr, .vts, .vtu.

#include "solver/mesh/io/GridFile.h"

#include <filesystem>

namespace vesicle
{

/// Reads ImageData, RectilinearGrid, StructuredGrid and UnstructuredGrid in one piece (more may be empty), in
/// all encodings, byte orders and compressions that VTK writes. Throws InputError with the array or the
/// attribute.
GridFile read_xml_grid(const std::filesystem::path& file);

}
