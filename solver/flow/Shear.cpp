#include "solver/flow/Shear.h"

#include <cmath>

namespace vesicle
{

const FlowKind& Shear::description()
{
  static const FlowKind kind{ "shear", "", "", "shear", "u = rate z e_x",
    { flow_parameter("rate", Dimension::rate, &Shear::rate, "of the shear, of any sign") },
    make_flow<Shear> };
  return kind;
}

Vector3 Shear::velocity_at(const Vector3& x) const
{
  return { rate * x.z(), 0, 0 };
}

double Shear::imposed_rate() const
{
  return std::abs(rate);
}

std::optional<ImposedFlow::Profile> Shear::profile() const
{
  return Profile{ Vector3::Zero(), Vector3::UnitZ(), Vector3::UnitX(), 1 };
}

}
