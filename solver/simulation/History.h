#pragma once
// A simulation run to its end, with what was observed on the way.

#include "solver/simulation/Simulation.h"

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

namespace vesicle
{

struct History
{
  std::shared_ptr<Simulation> simulation;
  std::vector<Diagnostics> rows; ///< of the first vesicle, the start first
  State last;

  const Diagnostics& end() const { return rows.back(); }
};

/// To the scene's end, or to the first step after `latest` in the scene's units (for scenes that
/// end when they are steady); `watch` is told every accepted step. Throws NumericalError.
History run_to_end(std::shared_ptr<Simulation> simulation, double latest = HUGE_VAL,
  const std::function<void(const Diagnostics&)>& watch = {});

/// Of the first vesicle: largest normal and tangential speed of the fluid at the vertices against the centroid, in r0 a
/// time unit μr0³/EB.
struct RelativeSpeeds
{
  double normal, tangential;
};
RelativeSpeeds relative_speeds(const History& run);

/// Largest rise of the bending energy from one step to the next, relative.
double largest_energy_rise(const History& run);
/// Largest |drift| of area and volume after any step, relative.
double largest_drift(const History& run);

}
