#pragma once
// Colours that differ from their neighbours by the same distance in CIELAB, so that equal steps of
// a value look equally large.

#include <array>
#include <vector>

namespace vesicle
{

using Color = std::array<double, 3>; ///< sRGB, 0 to 1

enum class ColorMap
{
  diverging, ///< blue, near white in the middle, red: as light on both sides
  sequential ///< dark blue to yellow, ever lighter (viridis without its darkest end)
};

/// `count` colours (two or more) from the map's low end to its high end. Light enough at the ends
/// for shading to show on them, told apart by colour-blind readers.
std::vector<Color> color_table(ColorMap map, int count);

}
