#pragma once
// What the scene asks for, dimensionless.

#include "solver/flow/ImposedFlow.h"
#include "solver/scene/Scene.h"

#include <memory>

namespace vesicle
{

/// The scene in units of r0, EB and μ. A term that isn't named is not computed anywhere.
struct Model
{
  bool bending = false;
  /// Bending from fitted curvatures: right at every vertex on any mesh, but no gradient of an
  /// energy of the mesh, as time stepping needs it. For single shapes.
  bool fitted_bending = false;
  bool incompressible = true;
  double bond = 0;                         ///< Δρ g r0⁴/EB; 0: no buoyancy
  std::shared_ptr<const ImposedFlow> flow; ///< dimensionless; empty: fluid at rest
  Scene::Scheme scheme = Scene::Scheme::robust;

  bool robust() const { return scheme == Scene::Scheme::robust; }
};

}
