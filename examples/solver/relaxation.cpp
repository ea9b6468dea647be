// A vesicle relaxes in a fluid at rest: the solver without VTK, a step at a time.

#include "solver/scene/SceneFile.h"
#include "solver/simulation/Simulation.h"
#include "solver/simulation/StartMesh.h"

#include <cstdio>
#include <exception>

namespace
{

const char* const scene_text = R"(
name = "relaxation"
[vesicle]
shape = "ellipsoid"
semi_axes = [1.3, 1.0, 0.8]
triangles = 180
[membrane]
bending_rigidity = 1.0
[time]
end = 0.2
output_every = 0.05
)";

void print(const vesicle::Diagnostics& d)
{
  std::printf("%8.4f %10.6f %12.3e\n", d.time, d.energy_over_8pi, d.area_drift);
}

/// The energy E/8πEB falls, as nothing drives the membrane.
void relax()
{
  const vesicle::Scene scene = vesicle::parse_scene(scene_text, "relaxation");
  vesicle::Simulation simulation(scene, vesicle::make_start_mesh(scene));
  vesicle::State state = simulation.start();
  std::printf("    time     E/8πEB   area drift\n");
  while (true)
  {
    if (simulation.schedule().due(state))
    {
      print(simulation.diagnose(state));
    }
    if (simulation.finished(state))
    {
      break;
    }
    state = simulation.step(simulation.ready(state));
  }
}

}

int main()
{
  try
  {
    relax();
  }
  catch (const std::exception& error) // InputError, NumericalError, IoError
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
