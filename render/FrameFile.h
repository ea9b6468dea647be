#pragma once
// A surface from a VTK file.

#include "vtkSmartPointer.h"

#include <filesystem>
#include <optional>

class vtkPolyData;

namespace vesicle
{

struct FrameFile
{
  vtkSmartPointer<vtkPolyData> surface;
  std::optional<double> time; ///< the field data TimeValue, where there is one
};

/// Reads the surface of a .vtp, .vtu or .vtk file. Throws InputError for other endings and for
/// what isn't a data set with triangles, IoError when the file can't be read.
FrameFile read_frame(const std::filesystem::path& file);

}
