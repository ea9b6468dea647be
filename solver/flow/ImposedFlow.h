#pragma once
// The imposed (background) flow u∞: the fluid's velocity as if there were no vesicle.

#include "solver/mesh/TriangleMesh.h"

#include <memory>
#include <optional>

namespace vesicle
{

struct FlowKind;

/// Base of the kinds of flow, each in a file of its own and in the list of FlowKinds.cpp. A flow is
/// plain data, the members that its kind declares as parameters, in any consistent units.
struct ImposedFlow
{
  virtual ~ImposedFlow() = default;

  /// What a flow of this kind is called and which parameters it has.
  virtual const FlowKind& kind() const = 0;

  /// u∞ at x, in the units of the flow; ∇·u∞ = 0.
  virtual Vector3 velocity_at(const Vector3& x) const = 0;

  /// How fast it deforms or turns a vesicle of radius 1, for the choice of time steps: ≥ 0, and 0
  /// for a uniform flow.
  virtual double imposed_rate() const = 0;

  /// A unidirectional flow whose velocity varies along a line across it.
  struct Profile
  {
    Vector3 center;
    std::optional<Vector3> across; ///< unit; empty: any direction normal to `along`
    Vector3 along;                 ///< unit, the direction of the flow
    double half_width;             ///< a distance over which the velocity shows its variation
  };
  /// Empty where the flow isn't one. Drawings use it.
  virtual std::optional<Profile> profile() const { return {}; }

  /// u∞ at the points: N by 3.
  virtual Points velocities(const Points& points) const;

  /// The same flow with lengths divided by `length` and velocities by `velocity`.
  virtual std::shared_ptr<const ImposedFlow> dimensionless(double length, double velocity) const;
  /// The same flow with velocities multiplied by a factor.
  virtual std::shared_ptr<const ImposedFlow> times(double factor) const;

  /// What it is at a time, in its units; empty: itself, always.
  virtual std::shared_ptr<const ImposedFlow> at(double /*time*/) const { return {}; }
  /// The first time after `time` where it isn't smooth in time, which steps must hit; empty: none.
  virtual std::optional<double> next_corner(double /*time*/) const { return {}; }
  /// Whether it is the same from `time` on.
  virtual bool settled(double /*time*/) const { return true; }
};

/// A flow as it is at a time; nothing, a fluid at rest, stays so.
std::shared_ptr<const ImposedFlow> flow_at(
  const std::shared_ptr<const ImposedFlow>& flow, double time);

}
