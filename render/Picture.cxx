#include "render/Picture.h"

#include "render/ColorBar.h"
#include "render/FlowLines.h"
#include "render/MarkerDots.h"
#include "render/PngFile.h"
#include "render/RenderBackend.h"
#include "render/SideChart.h"
#include "render/SurfaceMeasures.h"
#include "render/TextStyle.h"
#include "render/VelocityArrows.h"
#include "render/VesicleActor.h"
#include "solver/Errors.h"
#include "solver/flow/ImposedFlow.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <limits>

namespace vesicle
{
namespace
{

constexpr double margin = 1.27;     // room about the vesicle
constexpr double flow_margin = 1.7; // that with flow lines
constexpr int largest_side = 16384; // what llvmpipe draws

constexpr double vesicle_share = 0.63; // of a picture with a chart at its side

std::string formatted(const std::string& format, double value)
{
  char text[128];
  std::snprintf(text, sizeof text, format.c_str(), value);
  return text;
}

}

/// One text below the other at the upper left.
class TextColumn
{
public:
  void add_to(vtkRenderer* renderer, double pixels, bool bold)
  {
    auto text = vtkSmartPointer<vtkTextActor>::New();
    set_text_style(text->GetTextProperty(), pixels);
    text->GetTextProperty()->SetBold(bold);
    text->GetTextProperty()->SetVerticalJustificationToTop();
    renderer->AddActor2D(text);
    lines_.push_back(text);
  }

  /// Empty texts take no room.
  void show(const std::vector<std::string>& texts, double aspect)
  {
    constexpr double left = 0.044, top = 0.965, step = 0.058; // of the height
    double y = top;
    for (std::size_t i = 0; i < lines_.size(); ++i)
    {
      lines_[i]->SetVisibility(!texts[i].empty());
      lines_[i]->SetInput(texts[i].c_str());
      place_text(lines_[i], left / aspect, y);
      y -= texts[i].empty() ? 0 : step;
    }
  }

private:
  std::vector<vtkSmartPointer<vtkTextActor>> lines_;
};

void check_size(const std::array<int, 2>& size)
{
  for (const int side : size)
  {
    if (side < 16 || side > largest_side)
    {
      throw InputError(
        fmt::format("impossible picture size {} x {}: each side takes 16 to {} pixels", size[0],
          size[1], largest_side));
    }
  }
}

void check_range(const std::optional<Range>& range)
{
  if (range && !((*range)[0] < (*range)[1] && std::isfinite((*range)[1] - (*range)[0])))
  {
    throw InputError(
      fmt::format("the colour range [{}, {}] is not an interval", (*range)[0], (*range)[1]));
  }
}

void add_lamps(vtkRenderer* renderer)
{
  const auto add_lamp = [&](double x, double y, double z, double intensity)
  {
    vtkNew<vtkLight> lamp;
    lamp->SetLightTypeToCameraLight();
    lamp->SetPosition(x, y, z);
    lamp->SetFocalPoint(0, 0, 0);
    lamp->SetIntensity(intensity);
    renderer->AddLight(lamp);
  };
  add_lamp(-0.5, 0.6, 1, 0.82);
  add_lamp(0.7, -0.6, 0.7, 0.38);
}

ColorScale color_scale(vtkPolyData* surface, const std::string& name,
  const std::optional<Range>& range, const std::optional<double>& neutral)
{
  vtkDataArray* array = finite_point_array(surface, name);
  RangeFinder finder;
  if (!range)
  {
    finder.include(array);
  }
  return choose_color_scale(range ? *range : finder.range(),
    neutral ? *neutral : neutral_value(name, surface), array->GetNumberOfComponents() > 1);
}

ColorScale color_scale(const std::vector<vtkSmartPointer<vtkPolyData>>& surfaces,
  const std::string& name, const std::optional<Range>& range)
{
  check_range(range);
  RangeFinder finder;
  for (vtkPolyData* surface : surfaces)
  {
    finder.include(finite_point_array(surface, name));
  }
  return color_scale(surfaces.front(), name, range.value_or(finder.range()), std::nullopt);
}

vtkSmartPointer<vtkRenderWindow> off_screen_window(const std::array<int, 2>& size, int samples)
{
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(samples);
  window->SetSize(size[0], size[1]);
  window->SwapBuffersOff(); // to show samples takes longer than to draw them
  return window;
}

vtkSmartPointer<vtkImageData> grab_image(vtkRenderWindow* window)
{
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  grab->SetInputBufferTypeToRGB();
  grab->Update();
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->ShallowCopy(grab->GetOutput());
  return image;
}

struct Picture::Stage
{
  explicit Stage(PictureSettings s);

  void set_up_window();
  void set_up_markers();
  void add_marker(std::unique_ptr<CornerMarker> marker);
  void set_colors(vtkPolyData* surface);
  std::string show_arrows(vtkPolyData* surface, double radius);
  std::string show_flow(vtkPolyData* surface, bool along, std::optional<double> time);
  void set_texts(std::optional<double> time, const std::vector<std::string>& notes);
  void set_camera(vtkPolyData* surface, const Framing& framing);
  double font(double size) const { return font_size(size, settings.size[1]); }
  /// Pixels of the vesicle's part of the picture.
  int width() const;
  double aspect() const { return static_cast<double>(width()) / settings.size[1]; }
  /// What the colour bar leaves of it.
  double usable_width() const
  {
    return settings.color_bar ? 1 - ColorBar::share(width(), settings.size[1]) : 1;
  }

  PictureSettings settings;
  View view;
  std::optional<Framing> framing;
  std::optional<double> neutral;
  double least_arrow_speed = 0;
  std::optional<double> flow_speed;
  std::vector<Point3> marked;
  std::string time_format = "t = %.3g";
  ColorScale scale;

  ColorBar bar;
  VesicleActor vesicle;
  FlowLines flow;
  MarkerDots dots;
  TextColumn texts;
  vtkNew<vtkRenderer> ground; ///< nothing but the background
  vtkNew<vtkRenderer> renderer;
  std::vector<std::unique_ptr<CornerMarker>> markers;
  std::unique_ptr<SideChart> chart;
  vtkSmartPointer<vtkRenderWindow> window;
};

int Picture::Stage::width() const
{
  return settings.chart ? static_cast<int>(vesicle_share * settings.size[0]) : settings.size[0];
}

Picture::Stage::Stage(PictureSettings s)
  : settings((check_size(s.size), check_range(s.range), std::move(s))),
    view(View::named(settings.view)), bar(width(), settings.size[1]),
    vesicle({ settings.color, settings.smooth, settings.edges, settings.arrows,
              std::max(1., font_size(1, settings.size[1])) },
      bar.colors())
{
  render_backend();
  vesicle.add_to(renderer);
  flow.add_to(renderer);
  dots.add_to(renderer);
  add_lamps(renderer);
  if (settings.color_bar)
  {
    bar.add_to(renderer);
  }
  texts.add_to(renderer, font(font::large), true);
  texts.add_to(renderer, font(font::large), false);
  for (int note = 0; note < 2; ++note)
  {
    texts.add_to(renderer, font(font::small), false);
  }
  set_up_window();
  set_up_markers();
}

void Picture::Stage::set_up_window()
{
  // The whole is cleared at once, its parts would be by drawing over them.
  const auto& b = settings.background;
  ground->SetBackground(b[0], b[1], b[2]);
  renderer->EraseOff();
  window = off_screen_window(settings.size, settings.samples);
  window->AddRenderer(ground);
  window->AddRenderer(renderer);
  if (settings.chart)
  {
    const double left = static_cast<double>(width()) / settings.size[0];
    renderer->SetViewport(0, 0, left, 1);
    chart = std::make_unique<SideChart>(
      *settings.chart, std::array<double, 4>{ left, 0, 1, 1 }, settings.size);
    chart->renderer()->EraseOff();
    window->AddRenderer(chart->renderer());
  }
}

void Picture::Stage::set_up_markers()
{
  const auto slot = [this] { return Slot{ static_cast<int>(markers.size()), 0 }; };
  if (settings.axes)
  {
    add_marker(axes_marker(view, settings.size[0], settings.size[1], slot()));
  }
  for (const Guide& guide : settings.guides)
  {
    add_marker(guide_marker(guide, view, settings.size[0], settings.size[1], slot()));
  }
}

void Picture::Stage::add_marker(std::unique_ptr<CornerMarker> marker)
{
  if (marker)
  {
    window->SetNumberOfLayers(2);
    window->AddRenderer(marker->renderer());
    markers.push_back(std::move(marker));
  }
}

void Picture::Stage::set_colors(vtkPolyData* surface)
{
  scale = color_scale(surface, settings.color, settings.range, neutral);
  const bool vector = finite_point_array(surface, settings.color)->GetNumberOfComponents() > 1;
  bar.show(scale,
    settings.color_title.empty() ? array_title(settings.color, vector) : settings.color_title);
}

/// Says how fast the longest is.
std::string Picture::Stage::show_arrows(vtkPolyData* surface, double radius)
{
  if (!settings.arrows)
  {
    return "";
  }
  const double speed = std::max(least_arrow_speed, VelocityArrows::largest_speed(surface));
  vesicle.show_arrows(surface, speed, VelocityArrows::relative_length * radius);
  return fmt::format("longest arrow: speed {:.2g}", speed);
}

/// Says in which time the fluid goes along the lines. What the camera shows is known by now.
std::string Picture::Stage::show_flow(vtkPolyData* surface, bool along, std::optional<double> time)
{
  if (!settings.flow_lines)
  {
    return "";
  }
  vtkCamera* camera = renderer->GetActiveCamera();
  FlowPlane plane{ view, {}, 0, camera->GetParallelScale(), along,
    flow_at(settings.field, time.value_or(0)) };
  camera->GetFocalPoint(plane.center.data());
  plane.half_width = usable_width() * aspect() * plane.half_height;
  const double speed = flow_speed ? *flow_speed : largest_flow_speed(surface, plane);
  const FlowWays ways = speed > 0 ? flow_ways(surface, plane, speed) : FlowWays{};
  flow.show(ways, plane);
  return speed > 0 ? fmt::format("flow lines: the fluid's way in a time of {:.2g}", ways.time) : "";
}

void Picture::Stage::set_texts(std::optional<double> time, const std::vector<std::string>& notes)
{
  std::vector<std::string> all{ settings.title, time ? formatted(time_format, *time) : "" };
  all.insert(all.end(), notes.begin(), notes.end());
  texts.show(all, aspect());
}

void Picture::Stage::set_camera(vtkPolyData* surface, const Framing& room)
{
  Framing widened = room;
  if (settings.arrows)
  {
    widened.half_width += VelocityArrows::relative_length * room.radius;
    widened.half_height += VelocityArrows::relative_length * room.radius;
  }
  aim_camera(renderer->GetActiveCamera(), view,
    room.center ? *room.center : surface_centroid(surface), widened,
    settings.flow_lines ? flow_margin : margin, usable_width(), aspect());
}

Picture::Picture(PictureSettings settings) : stage_(std::make_unique<Stage>(std::move(settings))) {}

Picture::~Picture() = default;

void Picture::set_framing(const Framing& framing)
{
  stage_->framing = framing;
}

void Picture::set_range(const Range& range)
{
  stage_->settings.range = range;
}

void Picture::set_neutral(double value)
{
  stage_->neutral = value;
}

void Picture::set_least_arrow_speed(double speed)
{
  stage_->least_arrow_speed = speed;
}

void Picture::set_flow_speed(double speed)
{
  stage_->flow_speed = speed;
}

void Picture::set_markers(std::vector<Point3> places)
{
  stage_->marked = std::move(places);
}

void Picture::set_time_format(const std::string& format)
{
  stage_->time_format = format;
}

void Picture::draw(vtkPolyData* surface, std::optional<double> time)
{
  Stage& s = *stage_;
  Framing room;
  if (s.framing)
  {
    room = *s.framing;
  }
  else
  {
    room.include(surface, s.view);
  }
  s.set_colors(surface);
  s.vesicle.show(surface);
  s.dots.show(s.marked, room.radius);
  s.set_camera(surface, room);
  const std::string arrows = s.show_arrows(surface, room.radius);
  s.set_texts(time, { arrows, s.show_flow(surface, !room.center, time) });
  s.renderer->ResetCameraClippingRange();
  if (s.chart)
  {
    s.chart->show(time ? *time : std::numeric_limits<double>::lowest());
  }
  s.window->Render();
}

vtkSmartPointer<vtkImageData> Picture::image() const
{
  return grab_image(stage_->window);
}

void Picture::write_png(const std::filesystem::path& file) const
{
  vesicle::write_png(file, image());
}

const PictureSettings& Picture::settings() const
{
  return stage_->settings;
}

Range Picture::color_range() const
{
  return stage_->scale.range;
}

Point3 Picture::camera_focus() const
{
  Point3 focus;
  stage_->renderer->GetActiveCamera()->GetFocalPoint(focus.data());
  return focus;
}

double Picture::camera_scale() const
{
  return stage_->renderer->GetActiveCamera()->GetParallelScale();
}

vtkRenderWindow* Picture::window() const
{
  return stage_->window;
}

}
