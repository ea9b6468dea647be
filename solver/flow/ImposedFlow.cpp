#include "solver/flow/ImposedFlow.h"

#include "solver/flow/FlowKind.h"

namespace vesicle
{
namespace
{

template<class Value>
Value divided(const Value& value, Dimension dimension, double length, double velocity)
{
  switch (dimension)
  {
    case Dimension::rate:
      return value * (length / velocity);
    case Dimension::velocity:
      return value / velocity;
    case Dimension::length:
      return value / length;
    case Dimension::direction:
      break;
  }
  return value;
}

}

Points ImposedFlow::velocities(const Points& points) const
{
  Points u(points.rows(), 3);
  for (int i = 0; i < points.rows(); ++i)
    u.row(i) = velocity_at(points.row(i).transpose()).transpose();
  return u;
}

std::shared_ptr<const ImposedFlow> ImposedFlow::dimensionless(double length, double velocity) const
{
  const std::shared_ptr<ImposedFlow> flow = kind().make();
  for (const FlowParameter& parameter : kind().parameters)
    std::visit([&](auto member)
      { (*flow).*member = divided(this->*member, parameter.dimension, length, velocity); },
      parameter.member);
  return flow;
}

}
