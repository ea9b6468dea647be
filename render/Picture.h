#pragma once
// One picture of a vesicle: the surface coloured by a point array, colour bar, time, axes, what
// drives it, and a chart at its side.

#include "render/Chart.h"
#include "render/ColorScale.h"
#include "render/CornerMarker.h"
#include "render/View.h"

#include "vtkSmartPointer.h"

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkImageData;
class vtkPolyData;
class vtkRenderWindow;
class vtkRenderer;

namespace vesicle
{

struct ImposedFlow;

struct PictureSettings
{
  std::string color = "Mean_Curvature"; ///< point array; a vector is coloured by its magnitude
  std::string color_title;              ///< of the colour bar; empty: from the array's name
  std::optional<Range> range;           ///< empty: of the frame
  std::array<int, 2> size{ 1280, 720 }; ///< pixels
  std::string view = "auto";            ///< see View::named
  std::string title;                    ///< top left
  bool smooth = false;                  ///< Loop's limit surface through the vertices
  bool arrows = false;                  ///< the lipid flow, see VelocityArrows
  bool flow_lines = false;              ///< of the fluid, see FlowWays
  bool edges = false;                   ///< mesh edges
  /// Of a file, for flow lines: frames don't hold it.
  std::shared_ptr<const ImposedFlow> field;
  bool color_bar = true;
  bool axes = true;
  std::vector<Guide> guides;      ///< beside the axes
  std::optional<ChartSpec> chart; ///< at the right, against time
  int samples = 4;                ///< multisampling: soft outlines; 0: none
  std::array<double, 3> background{ 1, 1, 1 };
};

/// Throws InputError for an impossible size or range.
void check_size(const std::array<int, 2>& size);
void check_range(const std::optional<Range>& range);

/// A lamp to the upper left of the camera, which shows the shape better than a headlight, and a
/// weaker one opposite that keeps the colours readable in its shade.
void add_lamps(vtkRenderer* renderer);

/// The frame's colour scale; `range` and `neutral` where they are fixed.
ColorScale color_scale(vtkPolyData* surface, const std::string& array,
  const std::optional<Range>& range, const std::optional<double>& neutral);

/// That of several shapes together. Throws InputError for an impossible range, and as finite_point_array().
ColorScale color_scale(const std::vector<vtkSmartPointer<vtkPolyData>>& surfaces,
  const std::string& array, const std::optional<Range>& range);

/// A window off the screen. It doesn't show what it draws, so that grab_image alone can tell.
vtkSmartPointer<vtkRenderWindow> off_screen_window(const std::array<int, 2>& size, int samples);

/// What the window has drawn, RGB; a copy.
vtkSmartPointer<vtkImageData> grab_image(vtkRenderWindow* window);

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
  /// Fixes the colours' range, where the settings don't.
  void set_range(const Range& range);
  /// Fixes the value that neither colour has, see neutral_value; without it that of each frame.
  void set_neutral(double value);
  /// Each frame's longest arrow is as fast as its fastest point, but no slower than this: what is
  /// slower is drawn shorter. The picture says how fast the longest is.
  void set_least_arrow_speed(double speed);
  /// Flow lines are as long as the way in the time that this speed takes for the longest; without it
  /// the speed is the largest of each frame.
  void set_flow_speed(double speed);
  /// Dots on the membrane from the next frame on, see MembraneMarkers; none: none.
  void set_markers(std::vector<Point3> places);
  /// printf format of the time label, e.g. "t = %.2f".
  void set_time_format(const std::string& format);

  /// Draws the frame; a time label and the chart's points only where there is a time.
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
