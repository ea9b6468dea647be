#pragma once
// The exact first variation of the discrete bending energy of a smooth surface, as it follows the
// control points: what the energy that is reported does when they move.

#include "solver/membrane/MembraneTerm.h"

namespace vesicle
{

/// Of E = Σ_q r_q², r_q = √(dS_q/2) (2H_q − c0) over the rows of a table, which is ½ ∮ (2H − c0)² dS
/// (EB = 1): R = ∂r/∂c (CurvatureRates.h), the gradient 2 Rᵀr. 2 RᵀR is the Gauss–Newton part of the
/// second variation.
Variation bending_variation(
  const BasisTable& table, const SurfacePoints& surface, const Points& control, double c0);

}
