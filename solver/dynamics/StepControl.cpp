#include "solver/dynamics/StepControl.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vesicle
{

namespace
{

// Rounding must not leave a last step of length 1e-16.
constexpr double step_slack = 1e-9;

}

std::string reason_to_reject(const StepReport& r, const StepLimits& limits)
{
  if (!r.finite)
    return "positions are not finite";
  if (!(r.error <= limits.reject_error * limits.tolerance))
    return fmt::format("position error {:.1e} r0 over {} times the tolerance {:.1e}", r.error,
      limits.reject_error, limits.tolerance);
  if (!(r.displacement <= limits.displacement))
    return fmt::format(
      "a node moves by {:.2f} edges, over {}", r.displacement, limits.displacement);
  if (!(r.area_change <= limits.geometry_change))
    return fmt::format(
      "area changes by {:.1e}, over {:.1e}", r.area_change, limits.geometry_change);
  if (!(r.volume_change <= limits.geometry_change))
    return fmt::format(
      "volume changes by {:.1e}, over {:.1e}", r.volume_change, limits.geometry_change);
  if (!(r.constraint_left <= limits.constraint_left))
    return fmt::format("area and volume can't be restored: {:.1e} is left", r.constraint_left);
  if (!(r.energy_rise <= limits.energy_rise))
    return fmt::format("bending energy rises by {:.1e} of it in a fluid at rest, over {:.1e}",
      r.energy_rise, limits.energy_rise);
  if (!(r.energy_jump <= limits.energy_jump))
    return fmt::format("bending energy rises by {:.0f}% of it in one step, over {:.0f}%",
      100 * r.energy_jump, 100 * limits.energy_jump);
  if (!(r.gap >= (1 - limits.gap_share) * r.gap_before))
    return fmt::format("two vesicles' gap falls from {:.2g} to {:.2g} edges in one step, by more "
                       "than {:.0f}%",
      r.gap_before, r.gap, 100 * limits.gap_share);
  if (!(r.wall_gap >= (1 - limits.gap_share) * r.wall_gap_before))
    return fmt::format("the gap to the wall falls from {:.2g} to {:.2g} edges in one step, by more "
                       "than {:.0f}%",
      r.wall_gap_before, r.wall_gap, 100 * limits.gap_share);
  return {};
}

double wanted_step(double taken, double planned, const StepReport& report, const StepLimits& limits)
{
  double wanted = INFINITY;
  if (report.error > 0)
    wanted = limits.safety * std::sqrt(limits.tolerance / report.error) * taken;
  if (report.energy_rise > 0)
    wanted = std::min(wanted, limits.safety * limits.energy_rise / report.energy_rise * taken);
  return std::clamp(wanted, limits.shrink * taken, limits.growth * std::max(taken, planned));
}

double step_towards(double dt, double time, double target)
{
  const double left = target - time;
  if (left <= dt * (1 + step_slack))
    return left;
  return left < 2 * dt ? left / 2 : dt;
}

}
