#include "solver/flow/Poiseuille.h"

#include <cmath>

namespace vesicle
{
namespace
{

FlowKind poiseuille_description()
{
  FlowParameter velocity =
    flow_parameter("velocity", Dimension::velocity, &Poiseuille::velocity, "the speed on the axis");
  velocity.missing = "a finite number, the speed on the axis";
  FlowParameter radius =
    flow_parameter("radius", Dimension::length, &Poiseuille::radius, "where the fluid is at rest");
  radius.positive = true;
  FlowParameter axis =
    flow_parameter("axis", Dimension::direction, &Poiseuille::axis, "the direction of the tube");
  FlowParameter center =
    flow_parameter("center", Dimension::length, &Poiseuille::center, "a point on the axis");
  axis.required = center.required = false;
  return { "poiseuille", "", "", "Poiseuille",
    "u = velocity (1 − d²/radius²) axis, d the distance to the axis through center",
    { velocity, radius, axis, center }, make_flow<Poiseuille> };
}

}

const FlowKind& Poiseuille::description()
{
  static const FlowKind kind = poiseuille_description();
  return kind;
}

Vector3 Poiseuille::velocity_at(const Vector3& x) const
{
  const Vector3 from_axis = (x - center).cross(axis.normalized());
  return velocity * (1 - from_axis.squaredNorm() / (radius * radius)) * axis.normalized();
}

/// The shear rate at a distance of 1 from the axis.
double Poiseuille::imposed_rate() const
{
  return 2 * std::abs(velocity) / (radius * radius);
}

std::optional<ImposedFlow::Profile> Poiseuille::profile() const
{
  return Profile{ center, {}, axis, radius };
}

}
