#pragma once
// What is modelled of a scene: only what it names.

#include "solver/dynamics/OutputSchedule.h"
#include "solver/dynamics/Scales.h"
#include "solver/dynamics/Stepper.h"
#include "solver/scene/Scene.h"

namespace vesicle
{

/// The units in which a scene is computed; `mesh` is its start mesh, in the scene's units.
Scales scales_of(const Scene& scene, const TriangleMesh& mesh);

/// Bo = Δρ g r0⁴/EB.
double bond_number(const Scene::Gravity& gravity, const Scales& scales);

/// The membrane's own terms, dimensionless.
MembraneTerms membrane_terms(const Scene& scene, const SurfaceSpace& space, const Scales& scales);

/// The scene's vesicle on the triangles of a mesh of `nodes` vertices, and the flow, dimensionless.
/// `start`: the start shape's vertices on these triangles, in units of r0, for elastic
/// membranes.
System system_of(const Scene& scene, const Scales& scales, const Triangles& triangles, int nodes,
  const Points& start = {});

StepperSettings stepper_settings_of(const Scene& scene);
OutputSchedule schedule_of(const Scene& scene);

}
