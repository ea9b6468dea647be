#pragma once
// Axisymmetric equilibria of the bending energy: a meridian whose energy is stationary under given
// area and volume. They are where the search on a mesh starts from, and what it is held to.

#include "solver/equilibrium/EnergyProblem.h"
#include "solver/equilibrium/Meridian.h"

#include <string>

namespace vesicle
{

/// Families of equilibria, each a curve E(v) (Seifert, Berndl, Lipowsky, Phys. Rev. A 44 (1991) 1182).
enum class EquilibriumBranch
{
  prolate,
  oblate,
  stomatocyte
};
/// Throws InputError listing what is known.
EquilibriumBranch equilibrium_branch(const std::string& name);
std::string branch_name(EquilibriumBranch branch);
/// All of them, in the order of their definition.
std::vector<EquilibriumBranch> equilibrium_branches();

/// In units of r0 and EB; symmetric about the plane z = 0, or open to the top.
struct AxisymmetricShape
{
  Meridian meridian;
  double energy;
  Multipliers multipliers;
};

/// The branch's shape of that reduced volume, r0 = 1; its energy is right to 2e-7. The energy doesn't
/// know of contact: oblates of v < 0.503 pass through themselves. Throws InputError where the branch
/// has no shape, or none was found.
AxisymmetricShape axisymmetric_equilibrium(EquilibriumBranch branch, double reduced_volume);

}
