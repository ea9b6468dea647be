#include "solver/simulation/ErrorEstimate.h"

#include <fmt/format.h>

#include <algorithm>

namespace vesicle
{

double ErrorEstimate::space() const
{
  return std::max(energy.value_or(0), layer);
}

std::string to_text(const ErrorEstimate& e)
{
  const std::string energy = e.energy ? fmt::format("energy {:.1e}, ", *e.energy) : "";
  return fmt::format(
    "errors are about {:.1e} in space ({}single layer {:.1e}), {:.1e} in time (taken out "
    "of area and volume)",
    e.space(), energy, e.layer, e.time);
}

}
