#pragma once

#include "solver/flow/FlowKind.h"

namespace vesicle
{

/// The flow at the centre of a four-roll mill (Bentley, Leal, J. Fluid Mech. 167 (1986) 219) in the plane y = 0,
/// u = (rate/2) [((1 + α) x + (1 − α) z) e_x − ((1 − α) x + (1 + α) z) e_z]: planar extension at α = 1, a
/// shear along x = −z at α = 0, a rotation at α = −1.
struct FourRollMill final : ImposedFlow
{
  static const FlowKind& description();
  const FlowKind& kind() const override { return description(); }
  Vector3 velocity_at(const Vector3& x) const override;
  double imposed_rate() const override;

  double rate = 0; ///< of any sign
  double type = 1; ///< α
};

}
