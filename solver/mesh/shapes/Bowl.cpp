#include "solver/mesh/shapes/Bowl.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vesicle
{

// The hole's radius, in middle radii of the shell: the branch's shapes have narrower ones, but the
// triangles of an open bowl have room.
static constexpr double hole = 0.25;

Eigen::Vector2d bowl_meridian(double h, double share)
{
  const double reach = std::numbers::pi - std::asin(std::min(1., hole + h)), // to the rim
    outer = (1 + h) * reach, rim = std::numbers::pi * h, inner = (1 - h) * reach;
  const auto on_circle = [](double radius, double angle) -> Eigen::Vector2d {
    return { radius * std::sin(angle), -radius * std::cos(angle) };
  };
  double way = share * (outer + rim + inner);
  if (way <= outer)
    return on_circle(1 + h, way / (1 + h));
  way -= outer;
  if (way > rim)
    return on_circle(1 - h, reach - (way - rim) / (1 - h));
  const double turn = way / h; // 0 outside, π inside
  return on_circle(1 + h * std::cos(turn), reach) +
    h * std::sin(turn) * Eigen::Vector2d(std::cos(reach), std::sin(reach));
}

}
