#include "solver/flow/Uniform.h"

namespace vesicle
{

const FlowKind& Uniform::description()
{
  static const FlowKind kind{ "uniform", "", "", "uniform", "u = velocity",
    { flow_parameter("velocity", Dimension::velocity, &Uniform::velocity, "of the fluid") },
    make_flow<Uniform> };
  return kind;
}

Vector3 Uniform::velocity_at(const Vector3&) const
{
  return velocity;
}

}
