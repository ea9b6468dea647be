#pragma once
// A series as one HTML file that any browser shows without a network: the surface over time,
// coloured by any point array, and the run's diagnostics.

#include "apps/RunTable.h"

#include "render/Movie.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vesicle
{

struct HtmlPage
{
  std::string title;
  std::string color;              ///< array shown at first
  std::string view = "front";     ///< at first: front, side, top or iso
  std::optional<Range> range;     ///< of that array; empty, and for the others: of the series
  bool smooth = false;            ///< Loop's surface through the points, in about 5,000 triangles
  FrameSource frames;             ///< asked for once each, in order
  std::vector<double> times;      ///< one a frame
  bool timed = true;              ///< false: frames have numbers, not times
  std::optional<RunTable> table;  ///< diagnostics to plot
  std::vector<std::string> chart; ///< columns plotted at first
};

/// Throws InputError, saying how to get it, where this build is without vtk.js, and naming the
/// frame that can't be shown; IoError when the file can't be written.
///
/// What is in the page: triangles once for all frames that share them, points in single precision
/// about each frame's centroid, the arrays (vectors as their magnitude) in 2¹⁶ steps over their
/// range in the series, at most 2,000 rows of the table. Arrays that aren't finite everywhere or
/// not in every frame are left out. 25 frames of 1,280 triangles with all arrays take 0.9 MB
/// besides vtk.js (2.5 MB).
void write_html_page(const std::filesystem::path& file, const HtmlPage& page);

}
