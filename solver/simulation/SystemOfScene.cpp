#include "solver/simulation/SystemOfScene.h"

#include "solver/membrane/AreaDifference.h"
#include "solver/membrane/Buoyancy.h"
#include "solver/membrane/ElasticSheet.h"
#include "solver/membrane/HelfrichBending.h"
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

MembraneTerms membrane_terms(const Scene& scene, const SurfaceSpace& space, const Scales& scales)
{
  MembraneTerms terms;
  if (scene.membrane.bending_rigidity)
    terms.push_back(make_bending(space, scene.membrane.spontaneous_curvature * scales.length));
  if (scene.membrane.area_difference_stiffness)
    terms.push_back(std::make_unique<AreaDifference>(
      *scene.membrane.area_difference_stiffness, scene.membrane.area_difference));
  return terms;
}

System system_of(const Scene& scene, const Scales& scales, const Triangles& triangles, int nodes,
  const Points& start)
{
  const Scene::Accuracy& accuracy = scene.accuracy;
  auto space = std::make_unique<SurfaceSpace>(
    accuracy.basis, curvature_of(accuracy), triangles, nodes, accuracy.quadrature);
  Vesicle vesicle = make_vesicle(std::move(space), accuracy.quadrature);
  vesicle.conserved = accuracy.scheme != Scene::Scheme::paper;
  vesicle.motion = accuracy.mesh_motion == Scene::MeshMotion::material ? NodeMotionKind::material
                                                                       : NodeMotionKind::normal;
  vesicle.viscosity_ratio = scene.fluid.viscosity_ratio;
  vesicle.terms = membrane_terms(scene, *vesicle.space, scales);
  if (scene.membrane.shear_modulus)
    vesicle.terms.push_back(std::make_unique<ElasticSheet>(
      elastic_moduli(scene.membrane, scales), *vesicle.space, start / scene.membrane.prestretch));
  if (scene.membrane.incompressible)
    vesicle.incompressibility = make_incompressibility(*vesicle.space);
  if (scene.gravity)
    if (const double bond = bond_number(*scene.gravity, scales); bond != 0)
      vesicle.terms.push_back(make_buoyancy(*vesicle.space, bond));

  System system;
  system.vesicles.push_back(std::move(vesicle));
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
