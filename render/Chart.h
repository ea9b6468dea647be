#pragma once
// Line charts (time series, convergence) as PNG or SVG files.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vesicle
{

struct ChartLine
{
  enum class Style
  {
    line,
    dashed,
    points,
    cross ///< points that are marked among others
  };
  std::string label; ///< in the legend; empty: not there
  std::vector<double> x;
  std::vector<double> y; ///< as many as x; a value that is not finite is left out
  Style style = Style::line;
  std::optional<std::array<int, 3>> color = std::nullopt; ///< empty: the next of the chart's own
};

struct ChartSpec
{
  std::string title;
  std::string x_label;
  std::string y_label;
  std::vector<ChartLine> lines;
  bool log_x = false; ///< values must be positive; others are left out
  bool log_y = false;
  bool equal_axes = false; ///< a unit is as long up as it is across
};

/// Draws one chart off-screen, as SVG where the file's name ends so, otherwise as PNG. Throws InputError when x and y differ in length or nothing is left
/// to draw, IoError naming the file when it can't be written.
void write_chart(const std::filesystem::path& file, const ChartSpec& chart,
  std::array<int, 2> size = { 1280, 720 });

/// Several charts in one picture, row by row.
void write_charts(const std::filesystem::path& file, const std::vector<ChartSpec>& charts,
  int columns = 1, std::array<int, 2> size = { 1280, 720 });

}
