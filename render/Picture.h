#pragma once
// One picture of a vesicle: the surface coloured by a point array, colour bar, time, axes.

#include "render/ColorScale.h"
#include "render/View.h"

#include "vtkSmartPointer.h"

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

class vtkImageData;
class vtkPolyData;
class vtkRenderWindow;

namespace vesicle
{

struct PictureSettings
{
  std::string color = "Mean_Curvature"; ///< point array; a vector is coloured by its magnitude
  std::string color_title;              ///< of the colour bar; empty: from the array's name
  std::optional<Range> range;           ///< empty: of the frame
  std::array<int, 2> size{ 1280, 720 }; ///< pixels
  std::string view = "auto";            ///< see View::named
  std::string title;                    ///< top left
  bool arrows = false;                  ///< of the point array Velocity
  bool comoving = false;                ///< arrows relative to the centroid's velocity
  bool edges = false;                   ///< mesh edges
  bool color_bar = true;
  bool axes = true;
  bool smooth_outline = false; ///< FXAA: a softer silhouette for three times the work
  std::array<double, 3> background{ 1, 1, 1 };
};

/// Draws frames one after the other into one off-screen window. Throws InputError for settings
/// and frames that can't be drawn; std::runtime_error when there is nothing to draw with.
class Picture
{
public:
  explicit Picture(PictureSettings settings);
  ~Picture();
  Picture(const Picture&) = delete;
  Picture& operator=(const Picture&) = delete;

  /// Fixes the zoom; without it every frame fills the picture.
  void set_framing(const Framing& framing);
  /// Fixes the arrows' scale: the longest arrow's speed.
  void set_arrow_speed(double speed);
  /// printf format of the time label, e.g. "t = %.2f".
  void set_time_format(const std::string& format);

  /// Draws the frame with the camera at its centroid; a time label only where there is a time.
  void draw(vtkPolyData* surface, std::optional<double> time = {});

  /// The last frame drawn, RGB. A copy of the caller's own.
  vtkSmartPointer<vtkImageData> image() const;
  void write_png(const std::filesystem::path& file) const;

  const PictureSettings& settings() const;
  Range color_range() const; ///< of the last frame drawn
  Point3 camera_focus() const;
  double camera_scale() const; ///< half the picture's height in the frame's units
  vtkRenderWindow* window() const;

private:
  struct Stage;
  std::unique_ptr<Stage> stage_;
};

}
