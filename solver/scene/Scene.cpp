#include "solver/scene/Scene.h"

#include "solver/flow/VaryingFlow.h"

#include <algorithm>

namespace vesicle
{

bool Scene::splits_power() const
{
  return fluid.viscosity_ratio != 1 || membrane.surface_viscosity != 0 ||
    std::any_of(companions.begin(), companions.end(),
      [](const Companion& other)
      { return other.viscosity_ratio != 1 || other.membrane.surface_viscosity != 0; });
}

Scene::Companion Scene::companion() const
{
  const bool loaded = gravity && gravity->bond_number != 0.;
  return { vesicle, membrane, fluid.viscosity_ratio, loaded ? gravity : std::nullopt };
}

Scene Scene::alone(std::size_t number) const
{
  Scene scene = *this;
  scene.companions.clear();
  scene.interaction.reset();
  if (number > 0)
  {
    const Companion& own = companions.at(number - 1);
    scene.vesicle = own.vesicle;
    scene.membrane = own.membrane;
    scene.fluid.viscosity_ratio = own.viscosity_ratio;
    scene.gravity = own.gravity;
  }
  return scene;
}

Scene::Accuracy Scene::preset(Preset preset)
{
  Accuracy accuracy; // the members' defaults are those of "balanced"
  accuracy.preset = preset;
  switch (preset)
  {
    case Preset::paper:
      accuracy.scheme = Scheme::paper;
      accuracy.integrator = Integrator::imex_euler;
      accuracy.mesh_motion = MeshMotion::material;
      [[fallthrough]];
    case Preset::fast:
      accuracy.basis = Basis::linear;
      accuracy.bending = bending_of(accuracy.basis);
      accuracy.linear_tolerance = 1e-10; // its factorisation leaves a few iterations
      break;
    case Preset::balanced:
      break;
    case Preset::accurate:
      accuracy.quadrature = 6;
      accuracy.linear_tolerance = 1e-8;
      break;
  }
  return accuracy;
}

Scene::Bending Scene::bending_of(Basis basis)
{
  return basis == Basis::loop ? Bending::variational : Bending::cotan;
}

double Scene::preset_tolerance(Preset preset)
{
  return preset == Preset::accurate ? 1e-4 : 1e-3;
}

std::shared_ptr<const ImposedFlow> imposed_flow(const Scene& scene)
{
  return with_history(scene.flow, scene.flow_history);
}

}
