#pragma once

#include <filesystem>

class vtkImageData;

namespace vesicle
{

/// Writes a PNG at a low zlib level (level 9 takes three times as long for a few per cent).
/// Throws IoError naming the file when it can't be written in full.
void write_png(const std::filesystem::path& file, vtkImageData* image);

}
