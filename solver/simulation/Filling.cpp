#include "solver/simulation/Filling.h"

#include "solver/Errors.h"
#include "solver/mesh/TriangleTree.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace vesicle
{
namespace
{

constexpr int most_tries = 100'000;

/// Numbers that any standard library makes alike, which its distributions aren't held to.
class Random
{
public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  /// From 0 up to 1.
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  /// Uniform over all: K. Shoemake, in Graphics Gems III (1992) 124.
  Eigen::Quaterniond rotation()
  {
    using std::numbers::pi;
    const double u = unit(), a = 2 * pi * unit(), b = 2 * pi * unit();
    const double p = std::sqrt(1 - u), q = std::sqrt(u);
    return { q * std::cos(b), p * std::sin(a), p * std::cos(a), q * std::sin(b) };
  }

private:
  std::mt19937_64 engine_;
};

class Filler
{
public:
  Filler(const TriangleMesh& shape, const FillSettings& settings)
    : shape_(shape), tree_(shape), settings_(settings), random_(settings.seed),
      radius_(shape.points.rowwise().norm().maxCoeff())
  {
  }

  std::vector<Placement> fill()
  {
    while (static_cast<int>(placed_.size()) < settings_.count)
      add_one();
    return placed_;
  }

private:
  void add_one()
  {
    for (int attempt = 0; attempt < most_tries; ++attempt)
      if (const Placement candidate = somewhere(); is_inside(candidate) && is_apart(candidate))
      {
        placed_.push_back(candidate);
        return;
      }
    throw InputError(fmt::format(
      "{} of {} vesicles fitted into the region{}: the next found no place in {} tries; "
      "take fewer, a larger region or a smaller gap, or another seed",
      placed_.size(), settings_.count, settings_.wall ? " above the wall" : "", most_tries));
  }

  Placement somewhere()
  {
    const Vector3 half = settings_.region.half_sides();
    Placement placement;
    for (int k = 0; k < 3; ++k)
      placement.center[k] = settings_.region.center[k] + random_.between(-half[k], half[k]);
    if (settings_.turned)
      placement.turn = random_.rotation();
    return placement;
  }

  Points points_of(const Placement& placement) const
  {
    return (shape_.points * placement.turn.toRotationMatrix().transpose()).rowwise() +
      placement.center.transpose();
  }

  bool is_inside(const Placement& placement) const
  {
    const Points points = points_of(placement);
    return is_above_wall(points) &&
      std::all_of(points.rowwise().begin(), points.rowwise().end(),
        [&](const auto& point) { return settings_.region.contains(point.transpose()); });
  }

  bool is_above_wall(const Points& points) const
  {
    if (!settings_.wall)
      return true;
    const double height = settings_.wall->heights(points).minCoeff();
    return height > 0 && height >= settings_.gap;
  }

  bool is_apart(const Placement& candidate) const
  {
    return std::all_of(placed_.begin(), placed_.end(),
      [&](const Placement& other)
      {
        const double near = 2 * radius_ + settings_.gap;
        return (candidate.center - other.center).squaredNorm() >= near * near ||
          (keeps_away(candidate, other) && keeps_away(other, candidate));
      });
  }

  /// Whether the points of one are outside of the other and at least the gap away.
  bool keeps_away(const Placement& one, const Placement& other) const
  {
    const Points seen = (points_of(one).rowwise() - other.center.transpose()) *
      other.turn.toRotationMatrix(); // as the other was before it was turned
    return std::all_of(seen.rowwise().begin(), seen.rowwise().end(),
      [&](const auto& row)
      {
        const Vector3 point = row.transpose();
        if (point.norm() >= radius_ + settings_.gap)
          return true;
        const TriangleTree::Hit hit = tree_.nearest(point);
        const auto [a, b, c] = corners(shape_, hit.triangle);
        const bool outside = (b - a).cross(c - a).dot(point - a) > 0;
        return outside && hit.squared_distance >= settings_.gap * settings_.gap;
      });
  }

  const TriangleMesh& shape_;
  TriangleTree tree_;
  const FillSettings& settings_;
  Random random_;
  double radius_; ///< of the sphere about the shape
  std::vector<Placement> placed_;
};

}

bool FillRegion::contains(const Vector3& point) const
{
  const Vector3 x = point - center;
  switch (kind)
  {
    case Kind::box:
      return (x.cwiseAbs().array() <= sides.array() / 2).all();
    case Kind::tube:
      return std::abs(x[0]) <= sides[0] / 2 && std::hypot(x[1], x[2]) <= radius;
    case Kind::ball:
      break;
  }
  return x.norm() <= radius;
}

double FillRegion::volume() const
{
  using std::numbers::pi;
  switch (kind)
  {
    case Kind::box:
      return sides.prod();
    case Kind::tube:
      return pi * radius * radius * sides[0];
    case Kind::ball:
      break;
  }
  return 4 * pi / 3 * std::pow(radius, 3);
}

Vector3 FillRegion::half_sides() const
{
  switch (kind)
  {
    case Kind::box:
      return sides / 2;
    case Kind::tube:
      return { sides[0] / 2, radius, radius };
    case Kind::ball:
      break;
  }
  return Vector3::Constant(radius);
}

std::vector<Placement> fill(const TriangleMesh& shape, const FillSettings& settings)
{
  return Filler(shape, settings).fill();
}

}
