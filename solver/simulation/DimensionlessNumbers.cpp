#include "solver/simulation/DimensionlessNumbers.h"

#include "solver/Errors.h"
#include "solver/scene/MeasuredText.h"

#include <fmt/format.h>

#include <cmath>

namespace vesicle
{

namespace
{

// Beyond this, bending is below what a velocity is solved to.
constexpr double hopeless = 1e12;
// Beyond this, bending changes nothing that anybody measures.
constexpr double strange = 1e4;
// Shorter than this in the system's own time, nothing has moved at the end.
constexpr double no_time = 1e-6;

void require_usable(double scale, const char* name)
{
  if (!std::isnormal(scale) || scale < 0)
    throw InputError(
      fmt::format("the {} is {:.3g}, which can't be computed with: vesicle.radius or the mesh, "
                  "membrane.bending_rigidity and fluid.viscosity must be in one system of units",
        name, scale));
}

void require_bending_to_count(const std::optional<double>& number, const char* name)
{
  if (number && !(std::abs(*number) <= hopeless))
    throw InputError(
      fmt::format("{} = {:.3g}: bending is lost beside it in double precision. Are lengths, "
                  "rigidity and viscosity in one system of units? Leave out "
                  "membrane.bending_rigidity for a membrane without bending",
        name, *number));
}

std::string strange_number(const std::optional<double>& number, const char* name, const char* what)
{
  if (!number || std::abs(*number) <= strange)
    return {};
  return fmt::format(
    "{} = {:.3g}: {} is that many times stronger than bending. Are lengths, rigidity and "
    "viscosity in one system of units?",
    name, *number, what);
}

}

DimensionlessNumbers dimensionless_numbers(
  const Scene& scene, const Scales& scales, const System& system)
{
  require_usable(scales.length, "radius r0");
  require_usable(scales.time(), "time unit μ r0³/EB");
  require_usable(scales.velocity(), "velocity unit EB/(μ r0²)");
  require_usable(scales.tension(), "tension unit EB/r0²");
  require_usable(scales.force_density(), "unit EB/r0³ of forces an area");
  DimensionlessNumbers numbers{ scales.length, scales.time(), {}, {}, {}, scene.units };
  if (scene.membrane.bending_rigidity)
  {
    if (scene.gravity)
      numbers.bond = bond_number(*scene.gravity, scales);
    if (system.flow && system.flow->imposed_rate() > 0)
      numbers.capillary = system.flow->imposed_rate();
    require_bending_to_count(numbers.bond, "Bo");
    require_bending_to_count(numbers.capillary, "Ca");
  }
  if (scene.time.end && system.rate() > 0)
    numbers.duration = *scene.time.end / scales.time() * system.rate();
  return numbers;
}

std::string to_text(const DimensionlessNumbers& n)
{
  std::string text = fmt::format("r0 = {}, time unit μ r0³/EB = {}",
    measured_text(n.radius, "length", n.units), measured_text(n.time_unit, "time", n.units));
  if (n.bond)
    text += fmt::format(", Bo = {:.4g}", *n.bond);
  if (n.capillary)
    text += fmt::format(", Ca = {:.4g}", *n.capillary);
  return text;
}

std::string check_units(const DimensionlessNumbers& n)
{
  for (const std::string& warning :
    { strange_number(n.bond, "Bo", "the load"), strange_number(n.capillary, "Ca", "the flow") })
    if (!warning.empty())
      return warning;
  if (n.duration && *n.duration < no_time)
    return fmt::format(
      "time.end is {:.3g} of the time in which the shape changes: nothing will have moved. Are "
      "lengths, rigidity, viscosity and times in one system of units?",
      *n.duration);
  return {};
}

}
