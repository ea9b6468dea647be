#pragma once
// Runs of the shipped scenes.

#include "render/Chart.h"
#include "solver/simulation/History.h"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace vesicle::validation
{

/// A scene of data/scenes by its name, with overrides "table.key=value".
Scene scene_of(const std::string& name, const std::vector<std::string>& overrides = {});

/// From the scene's own start mesh, or from `start`; to the scene's end, or to the first step after
/// `latest` (for scenes that end when they are steady).
History simulate(const Scene& scene);
History simulate(const Scene& scene, const TriangleMesh& start, double latest = HUGE_VAL);

/// The row nearest to a time.
const Diagnostics& at_time(const History& run, double time);

/// Of the long axis to the flow, in degrees; NaN where there is none.
double inclination(const Diagnostics& d);

/// A quantity of every row against time.
ChartLine line_of(const History& run, const std::string& label,
  const std::function<double(const Diagnostics&)>& quantity);

}
