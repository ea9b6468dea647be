#pragma once
// VTK's XML files of surfaces: .vtp, .vtu, and .pvtp, .pvtu of pieces in files of their own.

#include "solver/mesh/io/SurfaceFile.h"

#include <filesystem>

namespace vesicle
{

/// Reads PolyData and UnstructuredGrid in all encodings, byte orders and compressions that VTK
/// writes; several pieces become one surface (SurfacePieces.h). Throws InputError with the array or
/// the piece.
SurfaceFile read_xml_surface(const std::filesystem::path& file);

}
