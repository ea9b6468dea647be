#pragma once

#include "solver/flow/FlowKind.h"

namespace vesicle
{

/// The flow in a round tube, without the tube: u = velocity (1 − d²/radius²) axis, d the distance
/// to the axis through center.
struct Poiseuille final : ImposedFlow
{
  Poiseuille() = default;
  Poiseuille(double speed, double tube_radius, const Vector3& direction = { 1, 0, 0 },
    const Vector3& point = { 0, 0, 0 })
    : velocity(speed), radius(tube_radius), axis(direction), center(point)
  {
  }

  static const FlowKind& description();
  const FlowKind& kind() const override { return description(); }
  Vector3 velocity_at(const Vector3& x) const override;
  double imposed_rate() const override;
  std::optional<Profile> profile() const override;

  double velocity = 0;       ///< on the axis, of any sign
  double radius = 1;         ///< where the fluid is at rest
  Vector3 axis{ 1, 0, 0 };   ///< unit
  Vector3 center{ 0, 0, 0 }; ///< a point on the axis
};

}
