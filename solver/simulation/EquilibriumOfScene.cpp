#include "solver/simulation/EquilibriumOfScene.h"

#include "solver/Errors.h"
#include "solver/mesh/Preparation.h"
#include "solver/simulation/StartMesh.h"
#include "solver/simulation/SystemOfScene.h"

#include <fmt/format.h>

#include <cmath>

namespace vesicle
{

void require_equilibrium(const Scene& scene)
{
  const auto refuse = [&](const char* has, const char* remedy)
  {
    throw InputError(
      fmt::format("scene '{}' {}, and an equilibrium is that of a membrane alone: {}", scene.name,
        has, remedy));
  };
  if (scene.vesicles() > 1)
    refuse("has several vesicles", "leave one, or let them run to time.end = \"steady\"");
  if (scene.flow)
    refuse("has a flow", "leave out [flow], or let it run to time.end = \"steady\"");
  if (scene.wall)
    refuse("has a wall", "leave out [wall], or let it run to time.end = \"steady\"");
  if (scene.gravity)
    refuse("has gravity", "leave out [gravity], or let it run to time.end = \"steady\"");
  if (!scene.membrane.bending_rigidity)
    refuse("has no bending", "set membrane.bending_rigidity");
  if (!scene.membrane.incompressible)
    refuse("has a membrane that isn't incompressible", "set membrane.incompressible = true");
  if (scene.accuracy.basis != SurfaceBasis::loop || scene.accuracy.bending == Scene::Bending::fit)
    refuse("has a preset without an energy of its own", "take accuracy.preset = \"balanced\"");
}

SceneEquilibrium equilibrium_of(
  const Scene& scene, TriangleMesh start, bool follow, const EquilibriumObserver& observer)
{
  require_equilibrium(scene);
  std::string notes = prepare_for_dynamics(start, scene.name);
  const Scales scales = scales_of(scene, start);
  const SurfaceSpace space(
    SurfaceBasis::loop, start.triangles, static_cast<int>(start.points.rows()));
  const MembraneTerms terms = membrane_terms(scene, space, scales);
  const Points points = start.points / scales.length;
  const AreaAndVolume kept(space, points);
  if (nearly_sphere(Surface(space, points)))
    throw InputError(fmt::format(
      "scene '{}' starts from a sphere, which is all that its area and volume allow", scene.name));
  const EnergyProblem problem{ space, terms, kept.area(), kept.volume() };
  Equilibrium equilibrium = equilibrium_below(problem, points, observer);
  if (follow && !equilibrium.stable())
    equilibrium =
      equilibrium_below(problem, pushed_along_lowest_mode(problem, equilibrium), observer);
  start.points = scales.length * equilibrium.vertices;
  return { std::move(start), std::move(equilibrium), scales, std::move(notes) };
}

}
