#include "solver/flow/Extension.h"

#include <cmath>

namespace vesicle
{
namespace
{

template<Extension::Type type>
std::unique_ptr<ImposedFlow> make_extension()
{
  return std::make_unique<Extension>(type);
}

FlowParameter rate_parameter()
{
  return flow_parameter(
    "rate", Dimension::rate, &Extension::rate, "of the strain along its axis, of any sign");
}

}

const FlowKind& Extension::description(Type type)
{
  static const FlowKind planar{ "extension", "planar", "x, −z", "planar extension",
    "u = rate (x e_x − z e_z)", { rate_parameter() }, make_extension<Type::planar> };
  static const FlowKind axisymmetric{ "extension", "axisymmetric", "z", "axisymmetric extension",
    "u = rate (z e_z − x/2 e_x − y/2 e_y)", { rate_parameter() },
    make_extension<Type::axisymmetric> };
  return type == Type::planar ? planar : axisymmetric;
}

Vector3 Extension::velocity_at(const Vector3& x) const
{
  if (type == Type::planar)
    return { rate * x.x(), 0, -rate * x.z() };
  return { -rate * x.x() / 2, -rate * x.y() / 2, rate * x.z() };
}

double Extension::imposed_rate() const
{
  return std::abs(rate);
}

}
