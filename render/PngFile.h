#pragma once

#include <filesystem>

class vtkImageData;

namespace vesicle
{

/// Writes an image of bytes (1 to 4 a pixel) as PNG. The file appears when it is complete. Throws
/// IoError naming it.
void write_png(const std::filesystem::path& file, vtkImageData* image);

}
