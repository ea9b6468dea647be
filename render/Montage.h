#pragma once
// Several shapes in one figure: one zoom, one colour scale, the time below each.

#include "render/Movie.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace vesicle
{

struct MontageSettings
{
  PictureSettings picture; ///< size, chart and title bar apart; without a range: that of all panels
  std::optional<std::array<int, 2>> size; ///< pixels; empty: as large as the shapes need
};

/// Panels from left to right, row by row, each about its shape's centroid; time labels where there
/// are times. Throws InputError naming the panel that can't be drawn, IoError naming the file.
void write_montage(const std::filesystem::path& file,
  const std::vector<vtkSmartPointer<vtkPolyData>>& panels, const std::vector<double>& times,
  const MontageSettings& settings);

/// `count` frames evenly spread in time, the first and the last among them. Indices in order, none
/// twice.
std::vector<int> spread_frames(const std::vector<double>& times, int count);

/// The frame nearest to each wanted time.
std::vector<int> nearest_frames(
  const std::vector<double>& times, const std::vector<double>& wanted);

}
