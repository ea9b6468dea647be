#pragma once
// What `vesicle equilibrium` says of a shape.

#include "solver/equilibrium/Equilibrium.h"
#include "solver/mesh/TriangleMesh.h"

#include <optional>
#include <string>
#include <vector>

namespace vesicle
{

/// In units of r0 and EB.
struct EquilibriumReport
{
  std::optional<std::string> branch;
  double reduced_volume;
  long triangles;
  double energy_over_8pi;
  /// Against the axisymmetric shape, relative; empty where there is none to hold it to.
  std::optional<double> energy_error;
  double tension, pressure;
  bool stable;
  std::vector<double> lowest_eigenvalues; ///< EB/r0⁴
  double imbalance;                       ///< EB/r0³
  int steps;
};

EquilibriumReport report_of(const Equilibrium& equilibrium, const TriangleMesh& mesh);
std::string to_json_text(const EquilibriumReport& report);
std::string to_text(const EquilibriumReport& report);

}
