#pragma once

#include "solver/flow/FlowKind.h"

namespace vesicle
{

/// A pure strain: planar, u = rate (x e_x − z e_z), or axisymmetric,
/// u = rate (z e_z − x/2 e_x − y/2 e_y).
struct Extension final : ImposedFlow
{
  enum class Type
  {
    planar,
    axisymmetric
  };

  explicit Extension(Type strain, double strain_rate = 0) : type(strain), rate(strain_rate) {}

  static const FlowKind& description(Type type);
  const FlowKind& kind() const override { return description(type); }
  Vector3 velocity_at(const Vector3& x) const override;
  double imposed_rate() const override;

  Type type;
  double rate; ///< of any sign
};

}
