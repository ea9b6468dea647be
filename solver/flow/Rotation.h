#pragma once

#include "solver/flow/FlowKind.h"

namespace vesicle
{

/// The fluid turns as a rigid body about an axis through the origin: u = rate axis × x.
struct Rotation final : ImposedFlow
{
  Rotation() = default;
  explicit Rotation(double angular_rate, const Vector3& direction = { 0, 0, 1 })
    : rate(angular_rate), axis(direction)
  {
  }

  static const FlowKind& description();
  const FlowKind& kind() const override { return description(); }
  Vector3 velocity_at(const Vector3& x) const override;
  double imposed_rate() const override;

  double rate = 0; ///< angle over time, of any sign: right-handed about the axis if positive
  Vector3 axis{ 0, 0, 1 }; ///< unit
};

}
