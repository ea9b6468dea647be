#pragma once
// What a start shape measures before it is meshed.

#include "solver/mesh/shapes/SphericalParametrisation.h"

namespace vesicle
{

struct ExactMeasures
{
  double area, volume;
  double bending_energy; ///< 2 ∮ H² dS (EB = 1): 8π on a sphere
};

/// By even azimuths and Fejér's first rule over the heights (L. Fejér, Math. Z. 37 (1933) 287), to
/// 1e-6 where the parametrisation is smooth on a hundredth of a great circle.
ExactMeasures exact_measures(const SphericalParametrisation& surface, Symmetry symmetry);

}
