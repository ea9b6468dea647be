#include "render/TextStyle.h"

#include "vtkCoordinate.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>

namespace vesicle
{
namespace
{

constexpr double gray = 0.12;
constexpr int least_pixels = 6;

}

double font_size(double size, int picture_height)
{
  return size * picture_height / design_height;
}

void set_text_style(vtkTextProperty* text, double pixels)
{
  text->SetFontFamilyToArial();
  text->SetFontSize(std::max(least_pixels, static_cast<int>(std::lround(pixels))));
  text->SetColor(gray, gray, gray);
  text->ItalicOff();
  text->BoldOff();
  text->ShadowOff();
}

void place_text(vtkTextActor* text, double x, double y)
{
  text->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  text->SetPosition(x, y);
}

}
