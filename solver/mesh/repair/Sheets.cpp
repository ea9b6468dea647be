#include "solver/mesh/repair/Sheets.h"

#include "solver/mesh/DisjointSets.h"
#include "solver/mesh/EdgeUses.h"
#include "solver/mesh/MeshIntegrals.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace vesicle
{
namespace
{

/// Of the way to the mean of its neighbours: parts what touches and is far from folding anything.
constexpr double drawn_back = 0.1;
/// Triangles on one another, up to rounding, in radians.
constexpr double same_angle = 1e-9;

using Pair = std::pair<EdgeUse, EdgeUse>;

class SheetParting
{
public:
  explicit SheetParting(TriangleMesh& mesh)
    : mesh_(mesh), uses_(mesh.triangles), patches_(static_cast<int>(mesh.triangles.rows())),
      corners_(3 * static_cast<int>(mesh.triangles.rows())), inward_(flat_volume(mesh) < 0)
  {
    for (int e = 0; e < uses_.size(); ++e)
      if (uses_[e].size() == 2)
        patches_.unite(uses_[e][0].triangle, uses_[e][1].triangle);
  }

  int part()
  {
    for (int e = 0; e < uses_.size(); ++e)
      for (const auto& [first, second] : pairs_at(uses_[e]))
        unite(first, second);
    return renumber();
  }

private:
  int corner_of(int triangle, int vertex) const
  {
    const auto row = mesh_.triangles.row(triangle);
    return 3 * triangle + (row[0] == vertex ? 0 : row[1] == vertex ? 1 : 2);
  }
  void unite(const EdgeUse& first, const EdgeUse& second)
  {
    corners_.unite(corner_of(first.triangle, first.a), corner_of(second.triangle, first.a));
    corners_.unite(corner_of(first.triangle, first.b), corner_of(second.triangle, first.b));
  }

  std::vector<Pair> pairs_at(std::span<const EdgeUse> uses);
  std::vector<EdgeUse> in_order_around(std::vector<EdgeUse> uses) const;
  std::vector<Pair> pairs_by_facing(const std::vector<EdgeUse>& uses) const;
  int renumber();

  TriangleMesh& mesh_;
  EdgeUses uses_;
  DisjointSets patches_; ///< triangles that edges of two connect
  DisjointSets corners_; ///< of one sheet; corner 3t + k is corner k of triangle t
  bool inward_;
};

std::vector<Pair> SheetParting::pairs_at(std::span<const EdgeUse> uses)
{
  if (uses.size() == 2)
    return { { uses[0], uses[1] } };
  std::map<int, std::vector<EdgeUse>> by_patch;
  for (const EdgeUse& use : uses)
    by_patch[patches_.find(use.triangle)].push_back(use);
  std::vector<Pair> pairs;
  std::vector<EdgeUse> rest;
  for (const auto& [patch, of_it] : by_patch)
    if (of_it.size() == 2)
      pairs.emplace_back(of_it[0], of_it[1]);
    else
      rest.insert(rest.end(), of_it.begin(), of_it.end());
  for (const Pair& pair : pairs_by_facing(in_order_around(rest)))
    pairs.push_back(pair);
  return pairs;
}

/// By the angle about the edge from a to b. Of triangles on one another that comes first whose
/// inside lies before it.
std::vector<EdgeUse> SheetParting::in_order_around(std::vector<EdgeUse> uses) const
{
  if (uses.empty())
    return uses;
  const Vector3 a = mesh_.points.row(uses[0].a), b = mesh_.points.row(uses[0].b);
  const Vector3 axis = (b - a).normalized();
  const Vector3 u = axis.unitOrthogonal(), v = axis.cross(u);
  std::vector<std::tuple<double, bool, EdgeUse>> placed;
  for (const EdgeUse& use : uses)
  {
    const int apex = mesh_.triangles.row(use.triangle).sum() - use.a - use.b;
    const Vector3 x = mesh_.points.row(apex).transpose() - a;
    const double angle = std::atan2(v.dot(x), u.dot(x));
    // The cut of the angles at ±π must not part what is on one another.
    const double turned = angle > std::numbers::pi - same_angle ? -std::numbers::pi : angle;
    placed.emplace_back(same_angle * std::round(turned / same_angle), use.forward == inward_, use);
  }
  std::stable_sort(placed.begin(), placed.end(),
    [](const auto& l, const auto& r) {
      return std::pair(std::get<0>(l), std::get<1>(l)) < std::pair(std::get<0>(r), std::get<1>(r));
    });
  std::ranges::transform(
    placed, uses.begin(), [](const auto& place) { return std::get<EdgeUse>(place); });
  return uses;
}

/// A triangle that runs from a to b has the inside before it, one from b to a behind it (the other
/// way round where all faces inward): neighbours in this order with the inside between them.
std::vector<Pair> SheetParting::pairs_by_facing(const std::vector<EdgeUse>& uses) const
{
  const std::size_t count = uses.size();
  for (std::size_t i = 0; i < count; ++i)
    if (uses[i].forward == uses[(i + 1) % count].forward)
      return {};
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < count; ++i)
    if (uses[i].forward == inward_)
      pairs.emplace_back(uses[i], uses[(i + 1) % count]);
  return pairs;
}

int SheetParting::renumber()
{
  const int points = static_cast<int>(mesh_.points.rows());
  std::vector<int> owner(points, -1); // the sheet's corner that keeps the point
  std::map<int, int> copy;            // of a corner's sheet: its new point
  std::vector<int> copied;            // of each new point: what it is a copy of
  std::vector<bool> shared(points, false);
  for (int t = 0; t < mesh_.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k)
    {
      int& corner = mesh_.triangles(t, k);
      const int sheet = corners_.find(3 * t + k);
      if (owner[corner] < 0)
        owner[corner] = sheet;
      if (owner[corner] == sheet)
        continue;
      shared[corner] = true;
      const auto [place, is_new] =
        copy.try_emplace(sheet, points + static_cast<int>(copied.size()));
      if (is_new)
        copied.push_back(corner);
      corner = place->second;
    }
  const Points old = mesh_.points;
  mesh_.points.conservativeResize(points + static_cast<Eigen::Index>(copied.size()), 3);
  for (std::size_t i = 0; i < copied.size(); ++i)
    mesh_.points.row(points + static_cast<Eigen::Index>(i)) = old.row(copied[i]);
  const Points before = mesh_.points;
  Points sum = Points::Zero(before.rows(), 3);
  std::vector<int> neighbours(before.rows(), 0);
  for (const auto& row : mesh_.triangles.rowwise())
    for (int k = 0; k < 3; ++k)
    {
      sum.row(row[k]) += before.row(row[(k + 1) % 3]) + before.row(row[(k + 2) % 3]);
      neighbours[row[k]] += 2;
    }
  for (int i = 0; i < before.rows(); ++i)
    if ((i >= points || shared[i]) && neighbours[i] > 0)
      mesh_.points.row(i) += drawn_back * (sum.row(i) / neighbours[i] - before.row(i));
  return static_cast<int>(std::ranges::count(shared, true));
}

}

int part_sheets(TriangleMesh& mesh)
{
  return SheetParting(mesh).part();
}

}
