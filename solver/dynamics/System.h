#pragma once
// What is modelled: vesicles and the flow that is imposed on them, in units of r0, EB and μ. What a
// scene doesn't name isn't here.

#include "solver/flow/ImposedFlow.h"
#include "solver/dynamics/Repulsion.h"
#include "solver/membrane/Incompressibility.h"
#include "solver/membrane/MembraneTerm.h"
#include "solver/stokes/LayerRules.h"
#include "solver/stokes/Wall.h"
#include "solver/surface/NodeMotion.h"

#include <memory>
#include <optional>
#include <vector>

namespace vesicle
{

struct Vesicle
{
  std::shared_ptr<const SurfaceSpace> space; ///< vesicles on the same mesh may share it,
  std::shared_ptr<const LayerRules> layer;   ///< and this
  MembraneTerms terms;
  double viscosity_ratio =
    1; ///< λ, of the fluid inside to that outside; other than 1 on smooth surfaces only
  /// η of the membrane, in μ r0; 0: none. Other than 0 on smooth surfaces only.
  double surface_viscosity = 0;
  std::unique_ptr<const Incompressibility> incompressibility; ///< none: no tension
  /// The energy that is reported where no term has one.
  std::unique_ptr<const MembraneTerm> curvature_energy;
  /// A row for the volume in the linear problem, area and volume restored after each step. The
  /// paper's scheme has neither.
  bool conserved = true;
  /// How the nodes of a smooth surface follow the fluid, which its loads are the adjoint of.
  NodeMotionKind motion = NodeMotionKind::normal;

  bool stiff() const;
  /// Of the terms that are the membrane's own; without any the curvature's, for reports.
  double energy(const Surface& surface) const;
  bool has_energy() const; ///< a term of the membrane's own
};

/// A vesicle without terms on `triangles` of `nodes` vertices; `quadrature` points a triangle.
Vesicle make_vesicle(SurfaceBasis basis, const Triangles& triangles, int nodes, int quadrature);
Vesicle make_vesicle(std::shared_ptr<const SurfaceSpace> space, int quadrature);
/// On the same mesh as `other`, with which it shares what the mesh fixes.
Vesicle make_vesicle_like(const Vesicle& other);

struct System
{
  std::vector<Vesicle> vesicles;
  std::shared_ptr<const ImposedFlow> flow; ///< none: at rest far away
  std::optional<Repulsion> repulsion;      ///< between vesicles; none: by the fluid alone
  std::optional<Wall> wall; ///< none: unbounded; beside smooth surfaces, where the flow is zero

  /// The rate that sets the pace, the largest of the terms' and the flow's; 0 if there is none.
  double rate() const;
  /// Nothing but its own membrane moves a vesicle, and the others the fluid: their energy can't rise.
  bool only_relaxes() const;
  /// Some membrane has a viscosity, or some fluid inside another than that outside.
  bool splits_power() const;
};

}
