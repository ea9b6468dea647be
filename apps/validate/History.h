#pragma once
// A simulation run to its end, with what was observed on the way.

#include "render/Chart.h"
#include "solver/dynamics/Simulation.h"

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace vesicle::validation
{

struct History
{
  std::shared_ptr<const Simulation> simulation;
  std::vector<Diagnostics> rows; ///< the start first
  State last;

  const Diagnostics& end() const { return rows.back(); }
};

/// A scene of data/scenes by its name, with overrides "table.key=value".
Scene scene_of(const std::string& name, const std::vector<std::string>& overrides = {});

/// From the scene's own start mesh, or from `start`; to the scene's end, or to the first step after
/// `latest` (for scenes that end when they are steady).
History simulate(const Scene& scene);
History simulate(const Scene& scene, const TriangleMesh& start, double latest = HUGE_VAL);

/// A quantity of every row against time.
ChartLine line_of(const History& run, const std::string& label,
  const std::function<double(const Diagnostics&)>& quantity);

/// Largest normal and tangential speed of the fluid at the vertices against the centroid, in r0 a
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
