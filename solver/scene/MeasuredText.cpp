#include "solver/scene/MeasuredText.h"

#include "solver/scene/Quantity.h"

#include <fmt/format.h>

namespace vesicle
{

std::string measured_text(double value, const char* what, Units units, int digits)
{
  return units == Units::si ? quantity_text(value, dimensions_of(what).front(), digits)
                            : fmt::format("{:.{}g}", value, digits);
}

}
