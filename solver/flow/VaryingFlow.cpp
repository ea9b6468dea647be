#include "solver/flow/VaryingFlow.h"

#include <algorithm>

namespace vesicle
{

Vector3 VaryingFlow::velocity_at(const Vector3& x) const
{
  return history_.factor(0) * flow_->velocity_at(x);
}

std::shared_ptr<const ImposedFlow> VaryingFlow::at(double time) const
{
  return flow_at(flow_, time)->times(history_.factor(time));
}

std::optional<double> VaryingFlow::next_corner(double time) const
{
  const auto own = history_.next_corner(time), inner = flow_->next_corner(time);
  return own && inner ? std::min(*own, *inner) : own ? own : inner;
}

bool VaryingFlow::settled(double time) const
{
  return history_.settled(time) && flow_->settled(time);
}

std::shared_ptr<const ImposedFlow> VaryingFlow::dimensionless(double length, double velocity) const
{
  return with_history(
    flow_->dimensionless(length, velocity), history_.in_units_of(length / velocity));
}

std::shared_ptr<const ImposedFlow> VaryingFlow::times(double factor) const
{
  return with_history(flow_->times(factor), history_);
}

std::shared_ptr<const ImposedFlow> with_history(
  const std::shared_ptr<const ImposedFlow>& flow, const FlowHistory& history)
{
  if (!flow || history.steady())
    return flow;
  return std::make_shared<const VaryingFlow>(flow, history);
}

}
