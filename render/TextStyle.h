#pragma once
// Letters of all pictures: sizes in pixels of a picture 720 high, growing with it.

class vtkTextActor;
class vtkTextProperty;

namespace vesicle
{

namespace font
{
inline constexpr double large = 28;
inline constexpr double medium = 24;
inline constexpr double small = 22;
}

inline constexpr double design_height = 720;

/// Size for a picture of this height.
double font_size(double size, int picture_height);

/// Dark and upright, of that many pixels.
void set_text_style(vtkTextProperty* text, double pixels);

/// In shares of the viewport's width and height.
void place_text(vtkTextActor* text, double x, double y);

}
