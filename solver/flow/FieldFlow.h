#pragma once

#include "solver/flow/FlowKind.h"
#include "solver/flow/VelocityField.h"

namespace vesicle
{

/// A flow that a file says. What reads such files isn't here: until `field` is set there is only the
/// file's name.
struct FieldFlow final : ImposedFlow
{
  static const FlowKind& description();
  const FlowKind& kind() const override { return description(); }
  Vector3 velocity_at(const Vector3& x) const override;
  Points velocities(const Points& points) const override;
  double imposed_rate() const override;
  std::shared_ptr<const ImposedFlow> dimensionless(double length, double velocity) const override;
  std::shared_ptr<const ImposedFlow> times(double factor) const override;
  std::shared_ptr<const ImposedFlow> at(double time) const override;
  std::optional<double> next_corner(double time) const override;
  bool settled(double time) const override;

  std::string file;                           ///< absolute
  std::shared_ptr<const VelocityField> field; ///< in the units of the file
  /// The units of this flow in those of the file.
  double length_unit = 1, velocity_unit = 1;
  double strength = 1; ///< multiplies the velocities
  double time = 0;     ///< in this flow's units

private:
  double time_unit() const { return length_unit / velocity_unit; }
  const VelocityField& given() const;
};

}
