#pragma once
// What is modelled of a scene: only what it names.

#include "solver/dynamics/OutputSchedule.h"
#include "solver/dynamics/Scales.h"
#include "solver/dynamics/Stepper.h"
#include "solver/scene/Scene.h"

namespace vesicle
{

/// The units in which a scene is computed; `mesh` is the start mesh of its first vesicle, in the
/// scene's units.
Scales scales_of(const Scene& scene, const TriangleMesh& mesh);

/// Bo = Δρ g r0⁴/EB.
double bond_number(const Scene::Gravity& gravity, const Scales& scales);

/// The own terms of the first vesicle's membrane, dimensionless.
MembraneTerms membrane_terms(const Scene& scene, const SurfaceSpace& space, const Scales& scales);

/// The mesh of a vesicle, for all shapes that it takes.
struct VesicleMesh
{
  Triangles triangles;
  int nodes; ///< vertices
  /// The vertices, in units of r0, of the start shape and of a reference that was read from a file; for
  /// elastic membranes.
  Points start = {}, reference = {};
};

/// The scene's vesicles, each on its mesh, and the flow, dimensionless.
System system_of(const Scene& scene, const Scales& scales, const std::vector<VesicleMesh>& meshes);

StepperSettings stepper_settings_of(const Scene& scene);
OutputSchedule schedule_of(const Scene& scene);

}
