#include "solver/flow/FlowNumbers.h"

#include "solver/Errors.h"
#include "solver/flow/FlowKinds.h"

#include <algorithm>

namespace vesicle
{
namespace
{

using Number = double ImposedFlow::*;
using Vector = Vector3 ImposedFlow::*;

/// A kind's speed and the axis that it goes along, if it has both.
struct AxialVelocity
{
  const FlowParameter* speed = nullptr;
  const FlowParameter* axis = nullptr;

  explicit AxialVelocity(const FlowKind& kind)
  {
    for (const FlowParameter& parameter : kind.parameters)
    {
      if (parameter.dimension == Dimension::velocity &&
        std::holds_alternative<Number>(parameter.member))
        speed = &parameter;
      if (parameter.dimension == Dimension::direction)
        axis = &parameter;
    }
    if (!speed || !axis)
      speed = axis = nullptr;
  }

  Vector3 of(const ImposedFlow& flow) const
  {
    return flow.*std::get<Number>(speed->member) * flow.*std::get<Vector>(axis->member);
  }

  /// A fluid at rest leaves the axis as it is.
  void set(ImposedFlow& flow, const Vector3& velocity) const
  {
    const double size = velocity.norm();
    flow.*std::get<Number>(speed->member) = size;
    if (size > 0)
      flow.*std::get<Vector>(axis->member) = velocity / size;
  }
};

void make_unit(Vector3& direction, const std::string& name)
{
  if (direction.isZero(0))
    throw InputError("the flow's " + name + " can't be the zero vector");
  direction.normalize();
}

std::vector<double> values_of(double value)
{
  return { value };
}

std::vector<double> values_of(const Vector3& value)
{
  return { value.data(), value.data() + 3 };
}

std::vector<double> values_of(const std::string&)
{
  return {};
}

std::span<double> span_of(std::string&)
{
  return {};
}

std::span<double> span_of(double& value)
{
  return { &value, 1 };
}

std::span<double> span_of(Vector3& value)
{
  return { value.data(), 3 };
}

}

std::vector<FlowNumbers> numbers_of(const ImposedFlow& flow)
{
  const AxialVelocity axial(flow.kind());
  std::vector<FlowNumbers> numbers;
  for (const FlowParameter& parameter : flow.kind().parameters)
  {
    if (&parameter == axial.speed)
      numbers.push_back({ parameter.name, values_of(axial.of(flow)) });
    else if (&parameter != axial.axis && parameter.dimension != Dimension::file)
      std::visit(
        [&](auto member) {
          numbers.push_back({ parameter.name, values_of(flow.*member) });
        },
        parameter.member);
  }
  return numbers;
}

std::shared_ptr<const ImposedFlow> flow_of(
  int kind, const std::function<void(const std::string& name, std::span<double> values)>& read)
{
  if (kind == 0)
    return {};
  const FlowKind& chosen = *flow_kinds().at(kind - 1);
  const AxialVelocity axial(chosen);
  const std::shared_ptr<ImposedFlow> flow = chosen.make();
  for (const FlowParameter& parameter : chosen.parameters)
  {
    if (&parameter == axial.axis || parameter.dimension == Dimension::file)
      continue;
    if (&parameter == axial.speed)
    {
      Vector3 velocity = Vector3::Zero();
      read(parameter.name, span_of(velocity));
      axial.set(*flow, velocity);
      continue;
    }
    std::visit(
      [&](auto member) { read(parameter.name, span_of((*flow).*member)); }, parameter.member);
    if (parameter.dimension == Dimension::direction)
      make_unit((*flow).*std::get<Vector>(parameter.member), parameter.name);
  }
  return flow;
}

}
