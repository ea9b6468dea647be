#pragma once
// Velocities that are known from elsewhere: a computed or measured flow.

#include "solver/mesh/TriangleMesh.h"

#include <vector>

namespace vesicle
{

struct VelocityField
{
  virtual ~VelocityField() = default;

  /// At points, N by 3, and a time, linear between the times that there are and constant outside.
  /// Throws NumericalError naming a point that isn't in the field.
  virtual Points velocities(const Points& points, double time) const = 0;
  /// How fast it deforms or turns a body of size 1 at most, 1 over a time.
  virtual double largest_rate() const = 0;
  /// At which it is known, ascending; one or none: it is steady.
  virtual const std::vector<double>& times() const = 0;
};

}
