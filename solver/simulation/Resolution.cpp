#include "solver/simulation/Resolution.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vesicle
{

Resolution::Resolution(const Triangles& triangles, int points)
  : rules_(triangles, points), triangles_(triangles.rows())
{
}

// As if the energy's error fell as 1/N² already, as it does where the shape is resolved: the least.
// To two digits.
static double triangles_needed(double triangles, double disagreement, double good)
{
  const double least = triangles * std::max(1.5, std::sqrt(disagreement / good)),
               unit = std::pow(10, std::floor(std::log10(least)) - 1);
  return unit * std::round(least / unit);
}

std::string Resolution::complaint(const Points& points, double allowed) const
{
  constexpr double good = 0.01;
  const LoopEnergy energy = rules_.energy(points);
  const double disagreement = energy.disagreement();
  if (!(disagreement > allowed)) // of NaN other guards tell
    return {};
  return fmt::format(
    "{} triangles don't hold the shape, and a smaller step can't help: its bending "
    "energy is known to {:.2g}% only, worst near ({:.3g}, {:.3g}, {:.3g}). It "
    "needs about {:.0f} triangles, or more",
    triangles_, 100 * disagreement, energy.worst.x(), energy.worst.y(), energy.worst.z(),
    triangles_needed(static_cast<double>(triangles_), disagreement, good));
}

}
