#pragma once
// The cases of `vesicle validate`, by name. Each family has a file of its own.

#include "apps/validate/Report.h"

#include <functional>
#include <string>
#include <vector>

namespace vesicle::validation
{

struct Case
{
  std::string name; ///< family/case
  std::string about;
  enum class Set
  {
    fast, ///< in both, coarser in the fast one
    full
  };
  Set set = Set::fast;
  std::function<void(Report&)> run;
};

std::vector<Case> curvature_cases();
std::vector<Case> segmented_cases();
std::vector<Case> operator_cases();
std::vector<Case> sphere_cases();
std::vector<Case> shear_cases();
std::vector<Case> two_fluid_cases();
std::vector<Case> several_cases();
std::vector<Case> wall_cases();
std::vector<Case> capsule_cases();
std::vector<Case> membrane_viscosity_cases();
std::vector<Case> equilibrium_cases();
std::vector<Case> buoyancy_cases();
std::vector<Case> relaxation_cases();
std::vector<Case> mesh_cases();

/// All of them, in the order of the paper's figures.
std::vector<Case> all_cases();
/// Those whose name or family is among `names`; none given: the set's. Throws InputError for a name
/// that isn't there, listing what is.
std::vector<Case> chosen_cases(const std::vector<std::string>& names, bool full);

/// Runs the case; a computation that stops becomes a failed row.
void run_case(const Case& item, Report& report);

}
