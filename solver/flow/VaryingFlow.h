#pragma once

#include "solver/flow/FlowHistory.h"
#include "solver/flow/ImposedFlow.h"

namespace vesicle
{

/// A flow whose strength has a history. As a flow of its own it is the one at time 0.
class VaryingFlow final : public ImposedFlow
{
public:
  VaryingFlow(std::shared_ptr<const ImposedFlow> flow, FlowHistory history)
    : flow_(std::move(flow)), history_(std::move(history))
  {
  }

  const FlowKind& kind() const override { return flow_->kind(); }
  Vector3 velocity_at(const Vector3& x) const override;
  double imposed_rate() const override { return history_.largest() * flow_->imposed_rate(); }
  std::optional<Profile> profile() const override { return flow_->profile(); }
  std::shared_ptr<const ImposedFlow> at(double time) const override;
  std::optional<double> next_corner(double time) const override;
  bool settled(double time) const override;
  std::shared_ptr<const ImposedFlow> dimensionless(double length, double velocity) const override;
  std::shared_ptr<const ImposedFlow> times(double factor) const override;

private:
  std::shared_ptr<const ImposedFlow> flow_;
  FlowHistory history_;
};

/// `flow` with that history: itself where it is steady, or nothing.
std::shared_ptr<const ImposedFlow> with_history(
  const std::shared_ptr<const ImposedFlow>& flow, const FlowHistory& history);

}
