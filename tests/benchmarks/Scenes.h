#pragma once
// What is timed.

#include "solver/simulation/Simulation.h"

#include <string>
#include <vector>

namespace vesicle::benchmarks
{

/// One of data/scenes with overrides "table.key=value".
Scene scene_of(const std::string& name, const std::vector<std::string>& overrides);
/// One of that many triangles, whose steps no output time cuts short.
Scene endless(const std::string& name, int triangles);

/// A run after its first steps.
struct Run
{
  explicit Run(const Scene& scene, int steps = 0);
  void step() { state = simulation.step(state); }

  Simulation simulation;
  State state;
};

/// The run of that name that the last repetition left, or its start. All are kept, as repetitions may be
/// mixed.
Run& kept_run(const std::string& name, const Scene& scene);

}
