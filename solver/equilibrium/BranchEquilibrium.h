#pragma once
// An equilibrium of a known branch on a mesh: from the axisymmetric shape to the triangles' own.

#include "solver/equilibrium/AxisymmetricShape.h"
#include "solver/equilibrium/Equilibrium.h"
#include "solver/mesh/TriangleMesh.h"

namespace vesicle
{

struct BranchEquilibrium
{
  TriangleMesh mesh; ///< vertices on the surface; r0 = 1
  Equilibrium equilibrium;
  double axisymmetric_energy; ///< of the branch's shape, in units of EB
};

/// What is asked for; `follow` leaves a branch where it is unstable, downhill.
struct BranchRequest
{
  EquilibriumBranch branch = EquilibriumBranch::prolate;
  double reduced_volume = 0.9;
  int triangles = 1280;
  bool follow = false;
};

/// Of bending alone, c0 = 0. Throws InputError, NumericalError.
BranchEquilibrium branch_equilibrium(
  const BranchRequest& request, const EquilibriumObserver& observer = {});

}
