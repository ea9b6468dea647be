#pragma once
// The energies of all branches of equilibria over the reduced volume: a table and a diagram.

#include <filesystem>

namespace vesicle
{

struct EquilibriumSweep
{
  double from, to, step; ///< reduced volumes
  int triangles;
};

/// Writes equilibria.csv and, where something can draw, equilibria.png. Returns the exit code.
int sweep_equilibria(const EquilibriumSweep& sweep, const std::filesystem::path& folder);

}
