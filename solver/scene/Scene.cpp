#include "solver/scene/Scene.h"

namespace vesicle
{

Scene::Accuracy Scene::preset(Preset preset)
{
  Accuracy accuracy; // the members' defaults are those of "fast" and, until there are Loop
                     // elements, "balanced"
  accuracy.preset = preset;
  switch (preset)
  {
    case Preset::paper:
      accuracy.scheme = Scheme::paper;
      accuracy.integrator = Integrator::imex_euler;
      accuracy.mesh_motion = MeshMotion::material;
      break;
    case Preset::fast:
    case Preset::balanced:
      break;
    case Preset::accurate:
      accuracy.quadrature = 6;
      break;
  }
  return accuracy;
}

double Scene::preset_tolerance(Preset preset)
{
  return preset == Preset::accurate ? 1e-4 : 1e-3;
}

}
