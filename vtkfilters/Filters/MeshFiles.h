#pragma once
// Surface meshes from and to files: as mesh_endings lists them.

#include "VesicleFiltersModule.h"

#include "vtkSmartPointer.h"

#include <filesystem>
#include <string>

class vtkPolyData;

namespace vesicle
{

inline constexpr const char* mesh_endings = ".vtu .vtp .vtk .stl .ply .obj .off .msh";

/// Reads a surface and its arrays (of .off, .stl and .msh the points and faces alone, of .obj the points' colours), also
/// .pvtu and .pvtp; polygons and strips come out as triangles, corners of an .stl file at the same
/// place as one point. Points keep the file's precision. Throws InputError naming the file, what is
/// wrong and a remedy, also for a file that ends early.
VESICLEFILTERS_EXPORT vtkSmartPointer<vtkPolyData> read_mesh(const std::filesystem::path& file);

/// Writes a triangle surface; .vtu, .vtp and .vtk keep the arrays, .ply the numbers of points and
/// triangles, .obj the normals and the points' colours (an array RGB, bytes or 0 to 1). Coordinates
/// are kept to the last bit but for .stl, which holds single precision. The file appears when it is
/// complete. Returns what it can't hold, arrays by name and shape that is lost by rounding, in a
/// sentence; empty: nothing. Throws InputError for an unknown ending, IoError if it can't be
/// written.
VESICLEFILTERS_EXPORT std::string write_mesh(
  vtkPolyData* surface, const std::filesystem::path& file);

/// Whether files of this ending have field data. Throws InputError as below.
VESICLEFILTERS_EXPORT bool keeps_field_data(const std::filesystem::path& file);

/// Throws InputError listing the endings unless the file's is one of them.
VESICLEFILTERS_EXPORT void require_mesh_ending(const std::filesystem::path& file);

}
