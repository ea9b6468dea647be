#pragma once

#include <filesystem>

class vtkImageData;

namespace vesicle
{

/// Writes a PNG at a low zlib level (level 9 takes three times as long for a few per cent).
/// The file appears when it is complete. Throws IoError naming it.
void write_png(const std::filesystem::path& file, vtkImageData* image);

}
