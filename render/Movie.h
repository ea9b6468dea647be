#pragma once
// A movie: numbered pictures with one zoom and one colour range throughout, and an MP4 of them.

#include "render/Picture.h"

#include "vtkSmartPointer.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

class vtkPolyData;

namespace vesicle
{

/// The surface of frame i, one of its own each time, as other threads ask for it: the first, then all
/// in order to measure them, and again to draw them where they are too many to be kept.
using FrameSource = std::function<vtkSmartPointer<vtkPolyData>(int)>;

struct MovieSettings
{
  PictureSettings picture;         ///< without a range: that of the whole movie, but for outliers
  int markers = 0;                 ///< on each vesicle, that its flow carries; see MembraneMarkers
  bool follow = true;              ///< the camera goes with the centroid; false: it stays
  std::filesystem::path directory; ///< of the pictures frame_000000.png, …; made where needed
  std::optional<std::filesystem::path> mp4; ///< the film; empty: pictures only
  /// Told after each frame how many of all are drawn; may throw to stop.
  std::function<void(int done, int total)> progress;
};

struct MovieReport
{
  int frames = 0;
  Range color_range{};
  Framing framing;
  std::optional<std::filesystem::path> mp4; ///< empty: none was asked for, or see note
  double frames_per_second = 0;             ///< of the film
  std::string note;                         ///< why there is no film
};

/// Draws one frame for each time. Pictures of an earlier movie in that folder are removed. Throws
/// InputError naming the frame that can't be drawn, IoError naming the file that can't be written.
MovieReport make_movie(
  const FrameSource& frames, const std::vector<double>& times, const MovieSettings& settings);

/// The same from meshes in files; time labels where every file holds its time (field data
/// TimeValue).
MovieReport make_movie(
  const std::vector<std::filesystem::path>& files, const MovieSettings& settings);

}
