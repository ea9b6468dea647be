#include "solver/dynamics/StageSolver.h"

#include "solver/Errors.h"
#include "solver/dynamics/CollocatedStages.h"
#include "solver/dynamics/LoadStages.h"

#include <algorithm>

namespace vesicle
{

std::unique_ptr<StageSolver> make_stage_solver(const System& system, const LayerSettings& layer)
{
  const bool smooth = std::all_of(system.vesicles.begin(), system.vesicles.end(),
    [](const Vesicle& vesicle) { return vesicle.space->smooth(); });
  if (smooth)
    return std::make_unique<LoadStages>(system, layer);
  if (system.wall)
    throw InputError("flat triangles know no walls: take Loop's surface");
  return std::make_unique<CollocatedStages>(system);
}

}
