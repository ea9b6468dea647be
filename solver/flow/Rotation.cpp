#include "solver/flow/Rotation.h"

#include <cmath>

namespace vesicle
{
namespace
{

FlowKind rotation_description()
{
  const FlowParameter rate =
    flow_parameter("rate", Dimension::rate, &Rotation::rate, "angle over time, right-handed");
  FlowParameter axis = flow_parameter("axis", Dimension::direction, &Rotation::axis,
    "what the fluid turns about, through the origin");
  axis.required = false;
  return { "rotation", "", "", "rotation", "u = rate axis × x", { rate, axis },
    make_flow<Rotation> };
}

}

const FlowKind& Rotation::description()
{
  static const FlowKind kind = rotation_description();
  return kind;
}

Vector3 Rotation::velocity_at(const Vector3& x) const
{
  return rate * axis.cross(x);
}

double Rotation::imposed_rate() const
{
  return std::abs(rate);
}

}
