#include "render/ColorBar.h"

#include "render/TextStyle.h"

#include "vtkCoordinate.h"
#include "vtkDoubleArray.h"
#include "vtkRenderer.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>

namespace vesicle
{
namespace
{

constexpr int labels = 6;
// In heights of the picture.
constexpr double room = 0.25;
constexpr double from_right = 0.2;
constexpr double title_from_right = 0.045;
constexpr double bar_width = 0.18; // numbers included
constexpr double widest = 0.5;     // of a narrow viewport

}

double ColorBar::share(int width, int height)
{
  return std::min(widest, room * height / width);
}

ColorBar::ColorBar(int width, int height)
{
  const double unit = static_cast<double>(height) / width;
  bar_->SetLookupTable(colors_);
  bar_->SetTitle("");
  bar_->UnconstrainedFontSizeOn();
  bar_->SetUseCustomLabels(true);
  bar_->SetDrawTickLabels(true);
  bar_->SetMaximumNumberOfColors(256);
  bar_->SetTextPositionToSucceedScalarBar();
  bar_->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  bar_->SetPosition(std::max(0., 1 - from_right * unit), 0.13);
  bar_->SetWidth(bar_width * unit);
  bar_->SetHeight(0.7);
  bar_->SetBarRatio(0.28);
  bar_->SetTextPad(static_cast<int>(std::lround(font_size(6, height))));
  set_text_style(bar_->GetLabelTextProperty(), font_size(font::small, height));
  set_text_style(title_->GetTextProperty(), font_size(font::medium, height));
  title_->GetTextProperty()->SetJustificationToRight();
  title_->GetTextProperty()->SetVerticalJustificationToBottom();
  place_text(title_, 1 - title_from_right * unit, 0.875);
}

void ColorBar::add_to(vtkRenderer* renderer)
{
  renderer->AddActor2D(bar_);
  renderer->AddActor2D(title_);
}

void ColorBar::show(const ColorScale& scale, const std::string& title)
{
  fill_color_table(colors_, scale);
  const auto ticks = round_ticks(scale.range, labels);
  vtkNew<vtkDoubleArray> numbers;
  for (const double tick : ticks)
  {
    numbers->InsertNextValue(tick);
  }
  bar_->SetCustomLabels(numbers);
  bar_->SetLabelFormat(number_format(ticks).c_str());
  title_->SetInput(title.c_str());
}

}
