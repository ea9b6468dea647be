#pragma once
// What a scene amounts to once the units are taken out: where they don't fit each other (a mesh in
// µm beside rigidities in J) it shows here.

#include "solver/simulation/SystemOfScene.h"

#include <optional>
#include <string>

namespace vesicle
{

struct DimensionlessNumbers
{
  double radius = 1;               ///< r0, in the scene's length
  double time_unit = 1;            ///< μ r0³/EB, in the scene's time
  std::optional<double> bond;      ///< Bo = Δρ g r0⁴/EB; with gravity and bending
  std::optional<double> capillary; ///< Ca = μ rate r0³/EB; with a flow that deforms, and bending
  std::optional<double> duration;  ///< time.end in the system's own time, 1 over its fastest rate
  Units units = Units::any;        ///< of the scene
};

/// Throws InputError where a scale is 0 or infinite in double precision, or bending is too weak
/// beside the flow or the load to be computed at all.
DimensionlessNumbers dimensionless_numbers(
  const Scene& scene, const Scales& scales, const System& system);

/// One line: "r0 = 1e-05, time unit μ r0³/EB = 10, Ca = 1", in SI "r0 = 10 um, …".
std::string to_text(const DimensionlessNumbers& numbers);

/// What is probably not meant; empty: nothing.
std::string check_units(const DimensionlessNumbers& numbers);

}
