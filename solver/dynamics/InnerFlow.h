#pragma once
// The Stokes flow inside a vesicle, of which the membrane's velocities are all that is known: its
// traction on the membrane, and so what it dissipates, ∮ u·σ·n dS.

#include "solver/dynamics/LayerMaps.h"
#include "solver/dynamics/VesicleLoads.h"

namespace vesicle
{

/// u = S t + K u + u/2 on the membrane seen from inside, t = σ·n at viscosity 1, n outward (C.
/// Pozrikidis, Boundary Integral and Singularity Methods, 1992, 2.3), is solved for t. Its part along n,
/// a pressure, does no work on a velocity without a flux, and is left out.
class InnerFlow
{
public:
  /// Of a vesicle alone, whatever is beside it. All must outlive it.
  InnerFlow(const VesicleLoads& loads, const LayerRules& rules, const LayerSettings& settings);

  /// t as a load, 3N: a functional of the control points' velocities. `velocity`: at the vertices, 3N,
  /// without a flux. Throws NumericalError.
  Eigen::VectorXd traction(const Eigen::VectorXd& velocity) const;

private:
  /// S of a load, and the flux that S makes no velocity of.
  Eigen::VectorXd velocity_of(const Eigen::VectorXd& load, double allowed) const;

  const VesicleLoads& loads_;
  LayerMaps layers_;
  SparseMatrix layer_inverse_; ///< preconditions
};

}
