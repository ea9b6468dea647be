#pragma once

#include "solver/flow/FlowKind.h"

namespace vesicle
{

/// u = rate z e_x.
struct Shear final : ImposedFlow
{
  Shear() = default;
  explicit Shear(double shear_rate) : rate(shear_rate) {}

  static const FlowKind& description();
  const FlowKind& kind() const override { return description(); }
  Vector3 velocity_at(const Vector3& x) const override;
  double imposed_rate() const override;
  std::optional<Profile> profile() const override;

  double rate = 0; ///< of any sign
};

}
