#include "solver/mesh/Triangulation.h"

#include "solver/Errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace vesicle
{
namespace
{

using Vector2 = Eigen::Vector2d;
using PolygonCorners = std::vector<std::int64_t>;

/// Twice an area below this part of a longest side squared is a line, up to rounding.
constexpr double flat = 1e-10;
/// Tests of a point against a triangle that a polygon may take, for each of its corners. Without
/// crossing sides a hundred are rarely needed.
constexpr std::int64_t tests_per_corner = 1000;

double cross(const Vector2& a, const Vector2& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/// Without corners that repeat the one before, and without the tips of sides that run back over
/// themselves.
PolygonCorners without_repeated(std::span<const std::int64_t> polygon)
{
  PolygonCorners kept;
  for (const std::int64_t corner : polygon)
  {
    if (kept.size() >= 2 && kept[kept.size() - 2] == corner)
      kept.pop_back();
    else if (kept.empty() || kept.back() != corner)
      kept.push_back(corner);
  }
  std::size_t first = 0; // the same around the end
  const auto left = [&] { return kept.size() - first; };
  while (left() > 1)
  {
    if (kept[first] == kept.back() || (left() > 2 && kept[first] == kept[kept.size() - 2]))
      kept.pop_back();
    else if (left() > 2 && kept[first + 1] == kept.back())
      ++first;
    else
      break;
  }
  return { kept.begin() + static_cast<std::ptrdiff_t>(first), kept.end() };
}

bool has_repeated(std::span<const std::int64_t> corners)
{
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i)
    if (corners[i] == corners[(i + 1) % n] || corners[i] == corners[(i + 2) % n])
      return true;
  return false;
}

/// The corners in the plane of their vector area, in which they run counter-clockwise.
std::vector<Vector2> in_own_plane(const Points& points, const PolygonCorners& corners)
{
  const Vector3 origin = points.row(corners[0]);
  const auto at = [&](std::size_t i) -> Vector3
  { return points.row(corners[i % corners.size()]).transpose() - origin; };
  Vector3 area = Vector3::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i)
    area += at(i).cross(at(i + 1));
  const Vector3 normal = area.normalized();
  const Vector3 x = normal.unitOrthogonal();
  const Vector3 y = normal.cross(x);
  std::vector<Vector2> result;
  result.reserve(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i)
    result.emplace_back(x.dot(at(i)), y.dot(at(i)));
  return result;
}

/// Corners by place: squares about as many as corners.
class CornerGrid
{
public:
  explicit CornerGrid(const std::vector<Vector2>& plane)
  {
    for (const Vector2& x : plane)
      box_.extend(x);
    side_ = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(plane.size()))));
    squares_.resize(static_cast<std::size_t>(side_) * side_);
  }

  void insert(int corner, const Vector2& x) { square(place(x)).push_back(corner); }

  /// Calls `visit(list)` with the corners of each square that the box meets until it returns false.
  template<typename Visit>
  bool visit(const Eigen::AlignedBox2d& box, Visit visit)
  {
    const Eigen::Array2i low = place(box.min()), high = place(box.max());
    for (int j = low.y(); j <= high.y(); ++j)
      for (int i = low.x(); i <= high.x(); ++i)
        if (!visit(square({ i, j })))
          return false;
    return true;
  }

private:
  Eigen::Array2i place(const Vector2& x) const
  {
    const Eigen::Array2d share = (x - box_.min()).array() / box_.sizes().array();
    const auto number = [this](double s) // also of 0/0
    { return s > 0 ? std::min(side_ - 1, static_cast<int>(std::min(s, 1.) * side_)) : 0; };
    return { number(share.x()), number(share.y()) };
  }
  std::vector<int>& square(const Eigen::Array2i& at)
  {
    return squares_[static_cast<std::size_t>(at.y()) * side_ + at.x()];
  }

  Eigen::AlignedBox2d box_;
  int side_ = 1;
  std::vector<std::vector<int>> squares_;
};

/// A ring of the corners left, from which ears are clipped.
class EarClipping
{
public:
  EarClipping(const Points& points, const PolygonCorners& corners)
    : corners_(corners), plane_(in_own_plane(points, corners)), next_(corners.size()),
      previous_(corners.size()), grid_(plane_), left_(static_cast<int>(corners.size()))
  {
    for (int i = 0; i < left_; ++i)
    {
      next_[i] = (i + 1) % left_;
      previous_[i] = (i + left_ - 1) % left_;
    }
    for (int i = 0; i < left_; ++i)
    {
      blocks_.push_back(!is_convex(i));
      if (blocks_[i])
        grid_.insert(i, plane_[i]);
    }
  }

  /// Adds the triangles; false if that takes too long.
  template<typename Add>
  bool clip(Add add)
  {
    tests_ = tests_per_corner * left_;
    int ear = 0;
    int refused = 0;
    while (left_ > 3)
    {
      // Where a whole round finds none, sides cross: any convex corner, or any at all.
      const bool forced = refused >= 2 * left_ || (refused >= left_ && is_convex(ear));
      if (forced || is_ear(ear))
      {
        add(corners_[previous_[ear]], corners_[ear], corners_[next_[ear]]);
        ear = take_away(ear);
        refused = 0;
        continue;
      }
      if (tests_ < 0)
        return false;
      ear = next_[ear];
      ++refused;
    }
    add(corners_[previous_[ear]], corners_[ear], corners_[next_[ear]]);
    return true;
  }

private:
  double twice_area(int a, int b, int c) const
  {
    return cross(plane_[b] - plane_[a], plane_[c] - plane_[a]);
  }
  double tolerance(int a, int b, int c) const
  {
    return flat *
      std::max({ (plane_[b] - plane_[a]).squaredNorm(), (plane_[c] - plane_[b]).squaredNorm(),
        (plane_[a] - plane_[c]).squaredNorm() });
  }
  bool is_convex(int i) const
  {
    const int a = previous_[i], c = next_[i];
    return twice_area(a, i, c) > tolerance(a, i, c);
  }
  bool same_place(int i, int j) const
  {
    return corners_[i] == corners_[j] || plane_[i] == plane_[j];
  }
  /// No other corner in the triangle or on its sides, where it would be cut off from its own.
  bool is_ear(int i)
  {
    --tests_;
    if (!is_convex(i))
      return false;
    const int a = previous_[i], c = next_[i];
    const double small = tolerance(a, i, c);
    const auto is_free = [&](std::vector<int>& square)
    {
      --tests_;
      for (std::size_t k = 0; k < square.size();)
      {
        --tests_;
        const int p = square[k];
        if (!blocks_[p])
        {
          square[k] = square.back();
          square.pop_back();
          continue;
        }
        if (!same_place(p, a) && !same_place(p, i) && !same_place(p, c) &&
          twice_area(a, i, p) >= -small && twice_area(i, c, p) >= -small &&
          twice_area(c, a, p) >= -small)
          return false;
        ++k;
      }
      return true;
    };
    Eigen::AlignedBox2d box(plane_[a]);
    box.extend(plane_[i]).extend(plane_[c]);
    return grid_.visit(box, is_free);
  }
  /// Returns where to look next: past the neighbour, so that triangles don't all meet in one.
  int take_away(int i)
  {
    const int a = previous_[i], c = next_[i];
    next_[a] = c;
    previous_[c] = a;
    --left_;
    blocks_[i] = false;
    blocks_[a] = blocks_[a] && !is_convex(a);
    blocks_[c] = blocks_[c] && !is_convex(c);
    return next_[c];
  }

  const PolygonCorners& corners_;
  std::vector<Vector2> plane_;
  std::vector<int> next_;
  std::vector<int> previous_;
  /// An ear with no corner in it that isn't convex has no other either. The grid may still have
  /// corners that have become convex or were taken away.
  std::vector<bool> blocks_;
  CornerGrid grid_;
  int left_;
  std::int64_t tests_ = 0;
};

/// The diagonal that leaves two triangles facing the same way; of two such, the shorter.
template<typename Add>
void cut_quad(const Points& points, std::span<const std::int64_t> q, Add add)
{
  const auto at = [&](int i) -> Vector3
  { return points.row(q[i % 4]).transpose() - points.row(q[0]).transpose(); };
  const Vector3 normal = (at(2) - at(0)).cross(at(3) - at(1)).normalized();
  const auto least_area = [&](int first)
  {
    const Vector3 a = at(first), b = at(first + 1), c = at(first + 2), d = at(first + 3);
    const double longest = std::max({ (b - a).squaredNorm(), (c - b).squaredNorm(),
      (d - c).squaredNorm(), (a - d).squaredNorm() });
    const double smaller =
      std::min(normal.dot((b - a).cross(c - a)), normal.dot((c - a).cross(d - a)));
    return longest > 0 ? smaller / longest : 0;
  };
  const double from_0 = least_area(0), from_1 = least_area(1);
  const bool both = from_0 > flat && from_1 > flat;
  const int first =
    (both ? (at(3) - at(1)).squaredNorm() < (at(2) - at(0)).squaredNorm() : from_1 > from_0) ? 1
                                                                                             : 0;
  add(q[first], q[first + 1], q[first + 2]);
  add(q[first], q[first + 2], q[(first + 3) % 4]);
}

template<typename Add>
bool cut(const Points& points, std::span<const std::int64_t> polygon, Add add)
{
  if (polygon.size() == 3 && !has_repeated(polygon))
  {
    add(polygon[0], polygon[1], polygon[2]);
    return true;
  }
  const PolygonCorners corners = without_repeated(polygon);
  if (corners.size() < 3)
    return true;
  if (corners.size() == 3)
  {
    add(corners[0], corners[1], corners[2]);
    return true;
  }
  if (corners.size() == 4)
  {
    cut_quad(points, corners, add);
    return true;
  }
  return EarClipping(points, corners).clip(add);
}

}

Triangulation triangulate(
  const Points& points, const PolygonList& polygons, const std::string& name)
{
  std::vector<std::array<int, 3>> triangles;
  Triangulation result;
  triangles.reserve(polygons.size());
  result.cell.reserve(polygons.size());
  for (std::int64_t i = 0; i < polygons.size(); ++i)
  {
    // Of a polygon that comes back to a corner a part may be an edge there and back.
    const auto add = [&](std::int64_t a, std::int64_t b, std::int64_t c)
    {
      if (a == b || b == c || c == a)
        return;
      triangles.push_back({ static_cast<int>(a), static_cast<int>(b), static_cast<int>(c) });
      result.cell.push_back(polygons.cell[i]);
    };
    if (!cut(points, polygons[i], add))
      throw InputError(fmt::format("{}: face {} of {} corners is too intricate to be cut into "
                                   "triangles; cut it in the program that made it",
        name, i, polygons[i].size()));
  }
  if (triangles.size() >= static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw InputError(fmt::format("{}: {} triangles are more than a mesh here can have, {}", name,
      triangles.size(), std::numeric_limits<int>::max()));
  result.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t i = 0; i < triangles.size(); ++i)
    result.triangles.row(static_cast<Eigen::Index>(i)) << triangles[i][0], triangles[i][1],
      triangles[i][2];
  return result;
}

}
