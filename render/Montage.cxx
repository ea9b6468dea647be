#include "render/Montage.h"

#include "render/ColorBar.h"
#include "render/PngFile.h"
#include "render/RenderBackend.h"
#include "render/TextStyle.h"
#include "render/VelocityArrows.h"
#include "render/VesicleActor.h"
#include "solver/Errors.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>

namespace vesicle
{
namespace
{

constexpr int most_columns = 6;
constexpr double largest_width = 1920;
constexpr double shape_height = 440; // pixels of the largest panel of a single row
constexpr double least_shape_height = 8;

/// Pixels of a figure 720 high, as for fonts.
constexpr double gap = 56;
constexpr double label_height = 52;
constexpr double edge = 30;
constexpr double bar_room = 0.29; // of the figure's height

/// Where everything is, in pixels from the lower left.
struct Layout
{
  int columns = 1, rows = 1;
  double width = 0, height = 0;
  double left = 0; ///< of the panels
  double cell_width = 0, cell_height = 0;
  double pixels_per_unit = 1;
  double unit = 1; ///< pixels of one design pixel

  double center_x(int panel) const { return left + (panel % columns + 0.5) * cell_width; }
  double center_y(int panel) const
  {
    return height - edge * unit - (panel / columns) * cell_height -
      0.5 * (cell_height - label_height * unit);
  }
};

double label_y(const Layout& layout, int panel)
{
  return layout.center_y(panel) - 0.5 * (layout.cell_height - layout.unit * label_height);
}

/// A layout with this many pixels a unit of length.
Layout layout_of(int panels, const Framing& room, bool markers, double pixels_per_unit, double unit)
{
  Layout layout;
  layout.columns = std::min(panels, most_columns);
  layout.rows = (panels + layout.columns - 1) / layout.columns;
  layout.pixels_per_unit = pixels_per_unit;
  layout.unit = unit;
  layout.cell_width = 2 * room.half_width * pixels_per_unit + gap * unit;
  layout.cell_height = 2 * room.half_height * pixels_per_unit + label_height * unit;
  layout.height = layout.rows * layout.cell_height + 2 * edge * unit;
  layout.left = markers ? 0.2 * layout.height : edge * unit;
  layout.width = layout.left + layout.columns * layout.cell_width + bar_room * layout.height;
  return layout;
}

Layout fitted_layout(
  int panels, const Framing& room, bool markers, const std::optional<std::array<int, 2>>& size)
{
  constexpr int rounds = 40;
  const int rows = (panels + most_columns - 1) / most_columns;
  // The largest scale whose figure fits, by halving.
  const double wide = size ? (*size)[0] : largest_width;
  const double high =
    size ? (*size)[1] : shape_height * std::min(2, rows) + 2 * edge + label_height * rows;
  double low = 0;
  double top = high / (2 * std::max(room.half_height, 1e-9 * room.radius));
  for (int i = 0; i < rounds; ++i)
  {
    const double middle = 0.5 * (low + top);
    const Layout trial = layout_of(panels, room, markers, middle, high / design_height);
    (trial.width <= wide && trial.height <= high ? low : top) = middle;
  }
  Layout layout = layout_of(panels, room, markers, low, high / design_height);
  if (2 * room.half_height * low < least_shape_height)
  {
    throw InputError("the figure is too small for its panels");
  }
  if (size)
  {
    layout.left += 0.5 * (wide - layout.width);
    layout.width = wide;
    layout.height = high;
  }
  return layout;
}

struct PanelSurvey
{
  Framing framing;
  RangeFinder values;
  double speed = 0;
};

PanelSurvey survey_panels(const std::vector<vtkSmartPointer<vtkPolyData>>& panels,
  const PictureSettings& picture, const View& view)
{
  PanelSurvey survey;
  for (const auto& surface : panels)
  {
    survey.framing.include(surface, view);
    survey.values.include(finite_point_array(surface, picture.color));
    if (picture.arrows)
    {
      survey.speed = std::max(survey.speed, VelocityArrows::largest_speed(surface));
    }
  }
  if (picture.arrows)
  {
    survey.framing.half_width += VelocityArrows::relative_length * survey.framing.radius;
    survey.framing.half_height += VelocityArrows::relative_length * survey.framing.radius;
  }
  return survey;
}

Point3 panel_shift(const Layout& layout, int panel, vtkPolyData* surface, const View& view)
{
  const Point3 center = surface_centroid(surface);
  const double x = (layout.center_x(panel) - 0.5 * layout.width) / layout.pixels_per_unit;
  const double y = (layout.center_y(panel) - 0.5 * layout.height) / layout.pixels_per_unit;
  Point3 shift;
  for (int i = 0; i < 3; ++i)
  {
    shift[i] = x * view.right[i] + y * view.up[i] - center[i];
  }
  return shift;
}

constexpr int samples = 8; // drawn once

/// The figure while it is drawn.
class Figure
{
public:
  Figure(const MontageSettings& settings, const Layout& layout, const View& view)
    : settings_(settings), layout_(layout),
      view_(view), size_{ static_cast<int>(layout.width), static_cast<int>(layout.height) },
      bar_(size_[0], size_[1]), window_(off_screen_window(size_, samples))
  {
    const auto& b = settings.picture.background;
    renderer_->SetBackground(b[0], b[1], b[2]);
    add_lamps(renderer_);
    bar_.add_to(renderer_);
    window_->AddRenderer(renderer_);
  }

  void show_colors(const ColorScale& scale, const std::string& title) { bar_.show(scale, title); }

  void add_panel(int panel, vtkPolyData* surface, const std::string& label, double radius)
  {
    const PictureSettings& p = settings_.picture;
    vesicles_.push_back(std::make_unique<VesicleActor>(
      VesicleActor::Look{ p.color, p.smooth, p.edges, p.arrows, std::max(1., layout_.unit) },
      bar_.colors()));
    VesicleActor& vesicle = *vesicles_.back();
    vesicle.show(surface);
    std::string text = label;
    if (p.arrows)
    {
      const double speed = VelocityArrows::largest_speed(surface);
      vesicle.show_arrows(surface, speed, VelocityArrows::relative_length * radius);
      text += fmt::format("{}longest arrow: {:.2g}", label.empty() ? "" : ", ", speed);
    }
    vesicle.place(panel_shift(layout_, panel, surface, view_));
    vesicle.add_to(renderer_);
    add_text(text, layout_.center_x(panel), label_y(layout_, panel));
  }

  void add_markers()
  {
    int row = 0;
    const auto add = [&](std::unique_ptr<CornerMarker> marker)
    {
      if (marker)
      {
        window_->SetNumberOfLayers(2);
        window_->AddRenderer(marker->renderer());
        markers_.push_back(std::move(marker));
        ++row;
      }
    };
    if (settings_.picture.axes)
    {
      add(axes_marker(view_, size_[0], size_[1], { 0, row }));
    }
    for (const Guide& guide : settings_.picture.guides)
    {
      add(guide_marker(guide, view_, size_[0], size_[1], { 0, row }));
    }
  }

  vtkSmartPointer<vtkImageData> draw(double radius)
  {
    vtkCamera* camera = renderer_->GetActiveCamera();
    Framing room{ 0, 0.5 * layout_.height / layout_.pixels_per_unit, 0, {} };
    room.radius = std::max(radius, room.half_height);
    aim_camera(camera, view_, { 0, 0, 0 }, room, 1, 1, 1);
    renderer_->ResetCameraClippingRange();
    window_->Render();
    return grab_image(window_);
  }

private:
  void add_text(const std::string& text, double x, double y)
  {
    auto actor = vtkSmartPointer<vtkTextActor>::New();
    set_text_style(actor->GetTextProperty(), font::medium * layout_.unit);
    actor->GetTextProperty()->SetJustificationToCentered();
    actor->GetTextProperty()->SetVerticalJustificationToTop();
    actor->SetInput(text.c_str());
    place_text(actor, x / layout_.width, (y - 10 * layout_.unit) / layout_.height);
    renderer_->AddActor2D(actor);
  }

  const MontageSettings& settings_;
  const Layout& layout_;
  const View& view_;
  std::array<int, 2> size_;
  ColorBar bar_;
  std::vector<std::unique_ptr<VesicleActor>> vesicles_;
  std::vector<std::unique_ptr<CornerMarker>> markers_;
  vtkNew<vtkRenderer> renderer_;
  vtkSmartPointer<vtkRenderWindow> window_;
};

std::string time_text(const std::string& format, double time)
{
  char text[64];
  std::snprintf(text, sizeof text, format.c_str(), time);
  return text;
}

}

void write_montage(const std::filesystem::path& file,
  const std::vector<vtkSmartPointer<vtkPolyData>>& panels, const std::vector<double>& times,
  const MontageSettings& settings)
{
  if (panels.empty())
  {
    throw InputError("a figure needs at least one shape");
  }
  const PictureSettings& picture = settings.picture;
  if (settings.size)
  {
    check_size(*settings.size);
  }
  check_range(picture.range);
  render_backend();
  const View view = View::named(picture.view);
  const PanelSurvey survey = survey_panels(panels, picture, view);
  const auto count = static_cast<int>(panels.size());
  const Layout layout =
    fitted_layout(count, survey.framing, picture.axes || !picture.guides.empty(), settings.size);
  const bool vector = finite_point_array(panels[0], picture.color)->GetNumberOfComponents() > 1;
  Figure figure(settings, layout, view);
  figure.show_colors(choose_color_scale(picture.range.value_or(survey.values.range()),
                       neutral_value(picture.color, panels[0]), vector),
    picture.color_title.empty() ? array_title(picture.color, vector) : picture.color_title);
  const std::string format = "t = " + number_format(times);
  for (int i = 0; i < count; ++i)
  {
    const auto k = static_cast<std::size_t>(i);
    figure.add_panel(
      i, panels[k], times.empty() ? "" : time_text(format, times[k]), survey.framing.radius);
  }
  figure.add_markers();
  write_png(file, figure.draw(survey.framing.radius));
}

std::vector<int> nearest_frames(const std::vector<double>& times, const std::vector<double>& wanted)
{
  std::vector<int> frames;
  for (const double time : wanted)
  {
    const auto nearest = std::min_element(times.begin(), times.end(),
      [time](double a, double b) { return std::abs(a - time) < std::abs(b - time); });
    frames.push_back(static_cast<int>(nearest - times.begin()));
  }
  return frames;
}

std::vector<int> spread_frames(const std::vector<double>& times, int count)
{
  std::vector<double> wanted;
  for (int i = 0; i < count && !times.empty(); ++i)
  {
    const double share = count > 1 ? static_cast<double>(i) / (count - 1) : 1;
    wanted.push_back(times.front() + share * (times.back() - times.front()));
  }
  auto frames = nearest_frames(times, wanted);
  frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
  return frames;
}

}
