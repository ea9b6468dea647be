#pragma once
// data/reference/equilibria.csv.

#include <string>
#include <vector>

namespace vesicle::test
{

struct ReferenceEquilibrium
{
  std::string branch;
  double reduced_volume, energy, tension, pressure; ///< E/8πEB, EB/r0², EB/r0³
};
std::vector<ReferenceEquilibrium> reference_equilibria();
/// The row of a branch and reduced volume.
ReferenceEquilibrium reference_equilibrium(const std::string& branch, double reduced_volume);

}
