#pragma once
// Shapes at rest without a fluid: Newton's method on the energy under constant area and volume.

#include "solver/equilibrium/EnergyProblem.h"
#include "solver/equilibrium/NormalModes.h"

#include <functional>

namespace vesicle
{

/// A surface on which the membrane's forces balance, in units of r0 and EB.
struct Equilibrium
{
  Points vertices;
  double energy, area, volume;
  Multipliers multipliers;
  double imbalance; ///< root mean square of the normal force density that is left
  int steps;
  NormalModes modes;
  /// No deformation lowers the energy.
  bool stable() const { return modes.eigenvalues[0] > 0; }
};

/// Where the search is heading for. Called before every step.
struct EquilibriumProgress
{
  int step;
  double energy;
  double move; ///< largest displacement of the step, in local edge lengths
};
using EquilibriumObserver = std::function<void(const EquilibriumProgress&)>;

/// The equilibrium near a shape, stable or not, a minimum of the energy or a saddle. The mesh slides
/// along the surface to where its energy is least, for the true one is never above that of any mesh.
/// Throws NumericalError where there is none near.
Equilibrium equilibrium_near(
  const EnergyProblem& problem, const Points& vertices, const EquilibriumObserver& observer = {});

/// The minimum of the energy downhill from a shape. Throws NumericalError.
Equilibrium equilibrium_below(
  const EnergyProblem& problem, const Points& vertices, const EquilibriumObserver& observer = {});

/// The vertices of an equilibrium pushed a little along its lowest mode, to go on from where it is
/// unstable.
Points pushed_along_lowest_mode(const EnergyProblem& problem, const Equilibrium& from);

}
