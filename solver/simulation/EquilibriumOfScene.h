#pragma once
// The shape at rest of a scene's vesicle, without its fluid.

#include "solver/dynamics/Scales.h"
#include "solver/equilibrium/Equilibrium.h"
#include "solver/scene/Scene.h"

namespace vesicle
{

struct SceneEquilibrium
{
  TriangleMesh mesh; ///< in the scene's units
  Equilibrium equilibrium;
  Scales scales;
  std::string notes; ///< of how the start mesh was made, for the user; empty if nothing
};

/// Downhill from the start mesh (in the scene's units), whose area and volume are kept; `follow`
/// leaves an equilibrium that turns out to be unstable. Throws InputError for scenes that have a flow,
/// gravity, flat triangles, no bending or a membrane that isn't incompressible, NumericalError.
SceneEquilibrium equilibrium_of(
  const Scene& scene, TriangleMesh start, bool follow, const EquilibriumObserver& observer = {});

/// Throws the InputErrors above, before a mesh is made.
void require_equilibrium(const Scene& scene);

}
