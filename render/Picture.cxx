#include "render/Picture.h"

#include "render/AxesMarker.h"
#include "render/PngFile.h"
#include "render/RenderBackend.h"
#include "render/SurfaceMeasures.h"
#include "render/VelocityArrows.h"
#include "solver/Errors.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkScalarBarActor.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>

namespace vesicle
{
namespace
{

constexpr double bar_share = 0.14;    // of the picture's width, kept free for the colour bar
constexpr double margin = 1.27;       // room about the vesicle
constexpr double arrow_length = 0.35; // of the vesicle's radius
constexpr int bar_labels = 6;
constexpr int largest_side = 16384; // what llvmpipe draws

/// Font sizes are in pixels at this height and grow with the picture.
constexpr double design_height = 720;
constexpr int large_font = 28;
constexpr int medium_font = 24;
constexpr int small_font = 22;
constexpr double text_gray = 0.12;

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

void set_text_style(vtkTextProperty* text, double size)
{
  text->SetFontFamilyToArial();
  text->SetFontSize(std::max(6, static_cast<int>(std::lround(size))));
  text->SetColor(text_gray, text_gray, text_gray);
  text->ItalicOff();
  text->BoldOff();
  text->ShadowOff();
}

void place_text(vtkTextActor* text, double x, double y)
{
  text->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  text->SetPosition(x, y);
}

std::string formatted(const std::string& format, double value)
{
  char text[128];
  std::snprintf(text, sizeof text, format.c_str(), value);
  return text;
}

}

struct Picture::Stage
{
  explicit Stage(PictureSettings s);

  void set_up_surface();
  void set_up_light();
  void set_up_texts();
  void set_up_bar();
  void set_surface(vtkPolyData* surface);
  void set_colors(vtkPolyData* surface);
  void set_arrows(vtkPolyData* surface, const Framing& framing);
  void set_camera(vtkPolyData* surface, const Framing& framing);
  double font(double size) const { return size * settings.size[1] / design_height; }

  PictureSettings settings;
  View view;
  std::optional<Framing> framing;
  std::optional<double> arrow_speed;
  std::string time_format = "t = %.3g";
  Range range{ 0, 1 };

  vtkNew<vtkPolyDataNormals> normals;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;
  vtkNew<vtkLookupTable> colors;
  VelocityArrows arrows;
  vtkNew<vtkScalarBarActor> bar;
  vtkNew<vtkTextActor> bar_title;
  vtkNew<vtkTextActor> title;
  vtkNew<vtkTextActor> time_label;
  vtkNew<vtkRenderer> renderer;
  std::unique_ptr<AxesMarker> axes;
  vtkSmartPointer<vtkRenderWindow> window;
};

Picture::Stage::Stage(PictureSettings s) : settings(std::move(s)), view(View::named(settings.view))
{
  check_size(settings.size);
  check_range(settings.range);
  render_backend();
  set_up_surface();
  set_up_light();
  set_up_texts();
  set_up_bar();
  const auto& b = settings.background;
  renderer->SetBackground(b[0], b[1], b[2]);
  renderer->SetUseFXAA(settings.smooth_outline);
  window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(settings.size[0], settings.size[1]);
  window->AddRenderer(renderer);
  if (settings.axes)
  {
    axes = std::make_unique<AxesMarker>(view, settings.size[0], settings.size[1]);
    window->SetNumberOfLayers(2);
    window->AddRenderer(axes->renderer());
  }
}

void Picture::Stage::set_up_surface()
{
  normals->SplittingOff();
  mapper->SetLookupTable(colors);
  mapper->SetScalarModeToUsePointFieldData();
  mapper->UseLookupTableScalarRangeOn();
  mapper->InterpolateScalarsBeforeMappingOn();
  actor->SetMapper(mapper);
  vtkProperty* look = actor->GetProperty();
  look->SetInterpolationToPhong();
  look->SetAmbient(0.3);
  look->SetDiffuse(0.8);
  look->SetSpecular(0.18);
  look->SetSpecularPower(35);
  look->SetEdgeVisibility(settings.edges);
  look->SetEdgeColor(0.2, 0.2, 0.22);
  look->SetLineWidth(static_cast<float>(std::max(1., font(1))));
  renderer->AddActor(actor);
  renderer->AddActor(arrows.actor());
  arrows.actor()->SetVisibility(settings.arrows);
}

void Picture::Stage::set_up_light()
{
  // A lamp to the upper left of the camera shows the shape better than a headlight; a weaker one
  // opposite keeps the colours readable in its shade.
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

void Picture::Stage::set_up_texts()
{
  const double left = 0.025;
  set_text_style(title->GetTextProperty(), font(large_font));
  title->GetTextProperty()->BoldOn();
  title->GetTextProperty()->SetVerticalJustificationToTop();
  title->SetInput(settings.title.c_str());
  place_text(title, left, 0.965);
  set_text_style(time_label->GetTextProperty(), font(large_font));
  time_label->GetTextProperty()->SetVerticalJustificationToTop();
  place_text(time_label, left, settings.title.empty() ? 0.965 : 0.905);
  renderer->AddActor2D(title);
  renderer->AddActor2D(time_label);
}

void Picture::Stage::set_up_bar()
{
  bar->SetLookupTable(colors);
  bar->SetTitle("");
  bar->UnconstrainedFontSizeOn();
  bar->SetUseCustomLabels(true);
  bar->SetDrawTickLabels(true);
  bar->SetMaximumNumberOfColors(256);
  bar->SetTextPositionToSucceedScalarBar();
  bar->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  bar->SetPosition(0.885, 0.13);
  bar->SetWidth(0.1);
  bar->SetHeight(0.7);
  bar->SetBarRatio(0.28);
  bar->SetTextPad(static_cast<int>(std::lround(font(6))));
  bar->SetVisibility(settings.color_bar);
  set_text_style(bar->GetLabelTextProperty(), font(small_font));
  set_text_style(bar_title->GetTextProperty(), font(medium_font));
  bar_title->GetTextProperty()->SetJustificationToRight();
  bar_title->GetTextProperty()->SetVerticalJustificationToBottom();
  bar_title->SetVisibility(settings.color_bar);
  place_text(bar_title, 0.975, 0.875);
  renderer->AddActor2D(bar);
  renderer->AddActor2D(bar_title);
}

void Picture::Stage::set_surface(vtkPolyData* surface)
{
  vtkDataArray* own = surface->GetPointData()->GetArray("Normals");
  if (own && own->GetNumberOfComponents() == 3)
  {
    vtkNew<vtkPolyData> with_normals;
    with_normals->ShallowCopy(surface);
    with_normals->GetPointData()->SetNormals(own);
    mapper->SetInputData(with_normals);
    return;
  }
  normals->SetInputData(surface);
  mapper->SetInputConnection(normals->GetOutputPort());
}

void Picture::Stage::set_colors(vtkPolyData* surface)
{
  vtkDataArray* array = finite_point_array(surface, settings.color);
  const bool vector = array->GetNumberOfComponents() > 1;
  range = settings.range.value_or(Range{});
  if (!settings.range)
  {
    RangeFinder finder;
    finder.include(array);
    range = finder.range();
  }
  fill_color_table(colors, vector ? ColorMap::sequential : ColorMap::diverging, range);
  if (vector)
  {
    colors->SetVectorModeToMagnitude();
  }
  mapper->SelectColorArray(settings.color.c_str());

  const auto ticks = round_ticks(range, bar_labels);
  vtkNew<vtkDoubleArray> labels;
  for (const double tick : ticks)
  {
    labels->InsertNextValue(tick);
  }
  bar->SetCustomLabels(labels);
  bar->SetLabelFormat(number_format(ticks).c_str());
  bar_title->SetInput(
    (settings.color_title.empty() ? array_title(settings.color, vector) : settings.color_title)
      .c_str());
}

void Picture::Stage::set_arrows(vtkPolyData* surface, const Framing& room)
{
  if (settings.arrows)
  {
    const double speed =
      arrow_speed ? *arrow_speed : VelocityArrows::largest_speed(surface, settings.comoving);
    arrows.show(surface, settings.comoving, speed, arrow_length * room.radius);
  }
}

void Picture::Stage::set_camera(vtkPolyData* surface, const Framing& room)
{
  Framing widened = room;
  if (settings.arrows)
  {
    widened.half_width += arrow_length * room.radius;
    widened.half_height += arrow_length * room.radius;
  }
  const double usable = settings.color_bar ? 1 - bar_share : 1;
  const double aspect = static_cast<double>(settings.size[0]) / settings.size[1];
  aim_camera(
    renderer->GetActiveCamera(), view, surface_centroid(surface), widened, margin, usable, aspect);
  renderer->ResetCameraClippingRange();
}

Picture::Picture(PictureSettings settings) : stage_(std::make_unique<Stage>(std::move(settings))) {}

Picture::~Picture() = default;

void Picture::set_framing(const Framing& framing)
{
  stage_->framing = framing;
}

void Picture::set_arrow_speed(double speed)
{
  stage_->arrow_speed = speed;
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
  s.set_surface(surface);
  s.set_arrows(surface, room);
  s.time_label->SetVisibility(time.has_value());
  s.time_label->SetInput(formatted(s.time_format, time.value_or(0)).c_str());
  s.set_camera(surface, room);
  s.window->Render();
}

vtkSmartPointer<vtkImageData> Picture::image() const
{
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(stage_->window);
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  grab->SetInputBufferTypeToRGB();
  grab->Update();
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->ShallowCopy(grab->GetOutput());
  return image;
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
  return stage_->range;
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
