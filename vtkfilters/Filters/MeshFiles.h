#pragma once
// Surface meshes from and to files: .vtu .vtp .vtk .stl .ply .obj .off.

#include "VesicleFiltersModule.h"

#include "vtkSmartPointer.h"

#include <filesystem>

class vtkPolyData;

namespace vesicle
{

/// Reads a surface and its arrays (of .obj and .off the points and faces alone); polygons and
/// strips come out as triangles, points that an .stl file repeats are merged. Throws InputError
/// naming the file, what is wrong and a remedy.
VESICLEFILTERS_EXPORT vtkSmartPointer<vtkPolyData> read_mesh(const std::filesystem::path& file);

/// Writes a triangle surface; .vtu, .vtp and .vtk keep the arrays. Coordinates are kept to the last
/// bit but for .stl and .ply, which hold single precision. The file appears when it is complete.
/// Throws InputError for an unknown ending, IoError if it can't be written.
VESICLEFILTERS_EXPORT void write_mesh(vtkPolyData* surface, const std::filesystem::path& file);

/// Throws InputError listing the endings unless the file's is one of them.
VESICLEFILTERS_EXPORT void require_mesh_ending(const std::filesystem::path& file);

}
