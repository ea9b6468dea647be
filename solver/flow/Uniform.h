#pragma once

#include "solver/flow/FlowKind.h"

namespace vesicle
{

/// u = velocity.
struct Uniform final : ImposedFlow
{
  Uniform() = default;
  explicit Uniform(const Vector3& u) : velocity(u) {}

  static const FlowKind& description();
  const FlowKind& kind() const override { return description(); }
  Vector3 velocity_at(const Vector3& x) const override;
  double imposed_rate() const override { return 0; }

  Vector3 velocity{ 0, 0, 0 };
};

}
