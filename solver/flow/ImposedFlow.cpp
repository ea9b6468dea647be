#include "solver/flow/ImposedFlow.h"

#include "solver/flow/FlowKind.h"

#include <algorithm>

namespace vesicle
{
namespace
{

template<class Scaled>
std::shared_ptr<const ImposedFlow> copy(const ImposedFlow& flow, Scaled scaled)
{
  const std::shared_ptr<ImposedFlow> result = flow.kind().make();
  for (const FlowParameter& parameter : flow.kind().parameters)
    std::visit(
      [&](auto member)
      {
        if constexpr (std::is_same_v<decltype(member), std::string ImposedFlow::*>)
          (*result).*member = flow.*member;
        else
          (*result).*member = scaled(flow.*member, parameter.dimension);
      },
      parameter.member);
  return result;
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
  return copy(*this,
    [=]<class Value>(const Value& value, Dimension dimension) -> Value
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
        case Dimension::number:
        case Dimension::file:
          break;
      }
      return value;
    });
}

std::shared_ptr<const ImposedFlow> ImposedFlow::times(double factor) const
{
  return copy(*this,
    [=]<class Value>(const Value& value, Dimension dimension) -> Value
    {
      const bool moves = dimension == Dimension::rate || dimension == Dimension::velocity;
      return moves ? Value(value * factor) : value;
    });
}

bool is_from_file(const FlowKind& kind)
{
  return std::any_of(kind.parameters.begin(), kind.parameters.end(),
    [](const FlowParameter& parameter) { return parameter.dimension == Dimension::file; });
}

std::shared_ptr<const ImposedFlow> flow_at(
  const std::shared_ptr<const ImposedFlow>& flow, double time)
{
  const std::shared_ptr<const ImposedFlow> then = flow ? flow->at(time) : nullptr;
  return then ? then : flow;
}

}
