#include "solver/simulation/SystemOfScene.h"

#include "solver/ParallelFor.h"
#include "solver/adaptation/EqualAreaSphere.h"
#include "solver/membrane/AreaDifference.h"
#include "solver/membrane/Buoyancy.h"
#include "solver/membrane/ElasticSheet.h"
#include "solver/membrane/HelfrichBending.h"
#include "solver/membrane/ScaledTerm.h"
#include "solver/surface/SurfaceMeasures.h"

#include <cmath>

namespace vesicle
{

double bond_number(const Scene::Gravity& gravity, const Scales& scales)
{
  if (gravity.bond_number)
    return *gravity.bond_number;
  return gravity.density_difference * gravity.acceleration * std::pow(scales.length, 4) /
    scales.energy;
}

namespace
{

VertexCurvature curvature_of(const Scene::Accuracy& accuracy)
{
  if (accuracy.bending == Scene::Bending::fit)
    return VertexCurvature::fitted;
  if (accuracy.scheme == Scene::Scheme::paper)
    return VertexCurvature::paper;
  return accuracy.basis == SurfaceBasis::loop ? VertexCurvature::weak : VertexCurvature::cotan;
}

}

/// Without units.
static ElasticModuli elastic_moduli(const Scene::Membrane& membrane, const Scales& scales)
{
  return { membrane.elasticity,
    *membrane.shear_modulus * scales.length * scales.length / scales.energy,
    membrane.dilation_modulus };
}

Scales scales_of(const Scene& scene, const TriangleMesh& mesh)
{
  return { equivalent_radius(surface_measures(scene.accuracy.basis, mesh).volume),
    scene.membrane.bending_rigidity.value_or(1), scene.fluid.viscosity };
}

/// With the rigidity that sets the unit of energy it is bending itself, to the bit.
static std::unique_ptr<const MembraneTerm> bending_of(
  const Scene::Membrane& membrane, const SurfaceSpace& space, const Scales& scales)
{
  auto bending = make_bending(space, membrane.spontaneous_curvature * scales.length);
  const double factor = *membrane.bending_rigidity / scales.energy;
  if (factor == 1)
    return bending;
  return std::make_unique<ScaledTerm>(std::move(bending), factor);
}

MembraneTerms membrane_terms(const Scene& scene, const SurfaceSpace& space, const Scales& scales)
{
  const Scene::Membrane& membrane = scene.membrane;
  MembraneTerms terms;
  if (membrane.bending_rigidity)
    terms.push_back(bending_of(membrane, space, scales));
  if (membrane.area_difference_stiffness)
    terms.push_back(std::make_unique<AreaDifference>(
      *membrane.area_difference_stiffness * (*membrane.bending_rigidity / scales.energy),
      membrane.area_difference));
  return terms;
}

/// With nothing but what its mesh fixes.
static Vesicle bare_vesicle(const Scene& scene, const VesicleMesh& mesh)
{
  const Scene::Accuracy& accuracy = scene.accuracy;
  return make_vesicle(std::make_shared<const SurfaceSpace>(accuracy.basis, curvature_of(accuracy),
                        mesh.triangles, mesh.nodes, accuracy.quadrature),
    accuracy.quadrature);
}

/// Vertices of a sheet's shape without stress.
static Points reference_of(
  const Scene::Membrane& membrane, const SurfaceSpace& space, const VesicleMesh& mesh)
{
  using Reference = Scene::Membrane::Reference;
  if (membrane.reference == Reference::sphere)
    return equal_area_sphere(Surface(space, mesh.start)) / membrane.prestretch;
  return (membrane.reference == Reference::file ? mesh.reference : mesh.start) /
    membrane.prestretch;
}

static void add_physics(
  Vesicle& vesicle, const Scene& scene, const Scales& scales, const VesicleMesh& mesh)
{
  const Scene::Accuracy& accuracy = scene.accuracy;
  vesicle.conserved = accuracy.scheme != Scene::Scheme::paper;
  vesicle.motion = accuracy.mesh_motion == Scene::MeshMotion::material ? NodeMotionKind::material
                                                                       : NodeMotionKind::normal;
  vesicle.viscosity_ratio = scene.fluid.viscosity_ratio;
  vesicle.terms = membrane_terms(scene, *vesicle.space, scales);
  if (scene.membrane.shear_modulus)
    vesicle.terms.push_back(std::make_unique<ElasticSheet>(elastic_moduli(scene.membrane, scales),
      *vesicle.space, reference_of(scene.membrane, *vesicle.space, mesh)));
  vesicle.surface_viscosity = scene.membrane.surface_viscosity / (scales.viscosity * scales.length);
  if (scene.membrane.incompressible)
    vesicle.incompressibility = make_incompressibility(*vesicle.space, vesicle.surface_viscosity);
  if (scene.gravity)
    if (const double bond = bond_number(*scene.gravity, scales); bond != 0)
      vesicle.terms.push_back(make_buoyancy(*vesicle.space, bond));
}

/// For each mesh the first one that has the same triangles, with which it shares what they fix.
static std::vector<std::size_t> first_alike(const std::vector<VesicleMesh>& meshes)
{
  std::vector<std::size_t> first;
  for (std::size_t v = 0; v < meshes.size(); ++v)
  {
    std::size_t like = 0;
    while (like < v &&
      !(first[like] == like && meshes[like].nodes == meshes[v].nodes &&
        same_triangles(meshes[like].triangles, meshes[v].triangles)))
      ++like;
    first.push_back(like);
  }
  return first;
}

System system_of(const Scene& scene, const Scales& scales, const std::vector<VesicleMesh>& meshes)
{
  System system;
  system.vesicles.resize(meshes.size());
  const std::vector<std::size_t> like = first_alike(meshes);
  parallel_for(meshes.size(),
    [&](std::size_t v)
    {
      if (like[v] == v)
        system.vesicles[v] = bare_vesicle(scene, meshes[v]);
    });
  parallel_for(meshes.size(),
    [&](std::size_t v)
    {
      if (like[v] != v)
        system.vesicles[v] = make_vesicle_like(system.vesicles[like[v]]);
      add_physics(system.vesicles[v], scene.alone(v), scales, meshes[v]);
    });
  if (scene.interaction)
    system.repulsion =
      Repulsion{ scene.interaction->repulsion * scales.length * scales.length / scales.energy,
        scene.interaction->range / scales.length };
  if (scene.wall)
    system.wall = Wall{ scene.wall->point / scales.length, scene.wall->normal };
  if (const auto flow = imposed_flow(scene))
    system.flow = flow->dimensionless(scales.length, scales.velocity());
  return system;
}

StepperSettings stepper_settings_of(const Scene& scene)
{
  StepperSettings settings;
  settings.integrator = scene.accuracy.integrator;
  settings.layer = { scene.accuracy.layer, scene.accuracy.precision,
    scene.accuracy.tree_tolerance };
  settings.linear_tolerance = scene.accuracy.linear_tolerance;
  // A step that the user has fixed is taken whatever its error is estimated at.
  settings.limits.tolerance = scene.time.step ? INFINITY : scene.time.tolerance;
  return settings;
}

OutputSchedule schedule_of(const Scene& scene)
{
  const auto flow = imposed_flow(scene);
  if (!flow || flow->settled(0))
    return { scene.time.output_every, scene.time.end };
  return { scene.time.output_every, scene.time.end,
    [flow](double time) { return flow->next_corner(time); } };
}

}
