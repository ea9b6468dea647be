#include "solver/dynamics/Proximity.h"

#include "solver/ParallelFor.h"
#include "solver/mesh/BoundingBox.h"

#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vesicle
{

namespace
{

using Box = Eigen::AlignedBox3d;

// The control points' box holds the surface; that of the vertices may not.
Box box_of(const Surface& surface)
{
  return bounding_box(surface.control).merged(bounding_box(surface.vertices));
}

// Of an equilateral triangle about that wide.
double edge_of(const Surface& surface)
{
  return std::sqrt(surface.area / static_cast<double>(surface.vertices.rows()));
}

std::vector<Box> boxes_of(const std::vector<Proximity::Side>& sides)
{
  std::vector<Box> boxes;
  boxes.reserve(sides.size());
  for (const Proximity::Side& side : sides)
    boxes.push_back(box_of(*side.surface));
  return boxes;
}

}

std::string to_text(const Gap& gap)
{
  const Vector3 place = (gap.place[0] + gap.place[1]) / 2;
  const std::string where =
    fmt::format("near ({:.4g}, {:.4g}, {:.4g})", place.x(), place.y(), place.z());
  if (gap.distance < 0)
    return fmt::format("vesicles {} and {} cross {}", gap.vesicle[0], gap.vesicle[1], where);
  return fmt::format(
    "vesicles {} and {} are {:.3g} apart {}", gap.vesicle[0], gap.vesicle[1], gap.distance, where);
}

Proximity::Proximity(std::vector<Side> sides, double reach)
  : sides_(std::move(sides)), searched_(sides_.size())
{
  const std::vector<Box> boxes = boxes_of(sides_);
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  std::vector<char> wanted(sides_.size(), 0);
  for (std::size_t a = 0; a < sides_.size(); ++a)
    for (std::size_t b = 0; b < sides_.size(); ++b)
      if (a != b && boxes[a].exteriorDistance(boxes[b]) <= reach)
      {
        pairs.emplace_back(a, b);
        wanted[b] = 1;
      }
  parallel_for(sides_.size(),
    [&](std::size_t v)
    {
      const Surface& surface = *sides_[v].surface;
      if (wanted[v])
        searched_[v] = std::make_unique<const Searched>(
          Searched{ TriangleTree({ surface.vertices, surface.space->triangles() }),
            SurfacePanels(sides_[v].rules->panels(), surface.control) });
    });
  std::vector<std::vector<NearVertex>> found(pairs.size());
  parallel_for(pairs.size(),
    [&](std::size_t p) { found[p] = near_vertices(pairs[p].first, pairs[p].second, reach); });
  for (const std::vector<NearVertex>& of_pair : found)
    near_.insert(near_.end(), of_pair.begin(), of_pair.end());
}

std::vector<Proximity::NearVertex> Proximity::near_vertices(
  std::size_t vesicle, std::size_t other, double reach) const
{
  const Points& vertices = sides_[vesicle].surface->vertices;
  const Box box = box_of(*sides_[other].surface);
  std::vector<NearVertex> near;
  for (int i = 0; i < vertices.rows(); ++i)
  {
    const Vector3 x = vertices.row(i).transpose();
    if (box.exteriorDistance(x) > reach)
      continue;
    const Place place = nearest(other, x);
    if (place.distance <= reach)
      near.push_back({ vesicle, i, other, place });
  }
  return near;
}

// On the panels of the elements around the nearest flat triangle, `hit`, for x nearer than the radius of
// curvature.
static Proximity::Place nearest_panel(const Proximity::Side& side, const TriangleTree::Hit& hit,
  const SurfacePanels& panels, const Vector3& x)
{
  const LayerRules& rules = *side.rules;
  const PanelBasis& basis = rules.panels();
  Proximity::Place best;
  const auto look = [&](int element)
  {
    for (int panel = basis.first(element); panel < basis.first(element + 1); ++panel)
    {
      if ((x - panels.center(panel)).norm() - panels.radius(panel) >= best.distance)
        continue;
      const SurfacePanels::Frame frame = panels.nearest(panel, x);
      const double distance = (x - frame.position).norm();
      if (distance < best.distance)
        best = { panel, frame.u, frame.v, frame.position, frame.cross().normalized(), distance,
          hit.triangle, hit.weights };
    }
  };
  look(hit.triangle);
  for (const int corner : side.surface->space->triangles().row(hit.triangle))
    for (const int* e = rules.touching().begin(corner); e != rules.touching().end(corner); ++e)
      if (*e != hit.triangle)
        look(*e);
  return best;
}

// Of a point that is farther than an edge the place nearest to one an edge off the surface towards it,
// again and again.
Proximity::Place Proximity::nearest(std::size_t vesicle, const Vector3& x) const
{
  constexpr int sweeps = 5;
  const auto& [tree, panels] = *searched_[vesicle];
  const Side& side = sides_[vesicle];
  const double edge = edge_of(*side.surface);
  const TriangleTree::Hit hit = tree.nearest(x);
  Place best;
  if (hit.squared_distance <= edge * edge)
    best = nearest_panel(side, hit, panels, x);
  else
  {
    const auto corner = corners(tree.mesh(), hit.triangle);
    best.position =
      hit.weights[0] * corner[0] + hit.weights[1] * corner[1] + hit.weights[2] * corner[2];
    for (int sweep = 0; sweep < sweeps; ++sweep)
    {
      const Vector3 off = best.position + edge * (x - best.position).normalized();
      best = nearest_panel(side, tree.nearest(off), panels, off);
    }
  }
  best.distance = (x - best.position).norm();
  if ((x - best.position).dot(best.normal) < 0)
    best.distance = -best.distance;
  return best;
}

// Newton's method for the least distance along the surface, with derivatives from differences: a
// vertex is up to an edge's square times the curvatures farther away.
Gap Proximity::between(const NearVertex& from) const
{
  struct Seen
  {
    Vector3 position;
    Place place;
  };
  const auto seen_from = [&](const Vector3& x)
  {
    const Vector3 own = nearest(from.vesicle, x).position;
    return Seen{ own, nearest(from.other, own) };
  };
  constexpr int sweeps = 4;
  const Surface& surface = *sides_[from.vesicle].surface;
  double step = edge_of(surface) / 3;
  Seen best{ surface.vertices.row(from.vertex).transpose(), from.place };
  for (int sweep = 0; sweep < sweeps; ++sweep, step /= 3)
  {
    const Vector3 a = best.place.normal.unitOrthogonal(), b = best.place.normal.cross(a);
    const auto at = [&](double s, double t)
    { return seen_from(best.position + step * (s * a + t * b)).place.distance; };
    const double here = best.place.distance, a_plus = at(1, 0), a_minus = at(-1, 0),
                 b_plus = at(0, 1), b_minus = at(0, -1), both = at(1, 1);
    const Eigen::Vector2d slope((a_plus - a_minus) / 2, (b_plus - b_minus) / 2);
    Eigen::Matrix2d curvature;
    curvature(0, 0) = a_plus + a_minus - 2 * here;
    curvature(1, 1) = b_plus + b_minus - 2 * here;
    curvature(0, 1) = curvature(1, 0) = both - a_plus - b_plus + here;
    Eigen::Vector2d move = -slope.normalized();
    if (curvature.determinant() > 0 && curvature.trace() > 0)
      move = -curvature.inverse() * slope;
    if (!move.allFinite())
      break;
    constexpr double longest = 2; // steps
    if (move.norm() > longest)
      move *= longest / move.norm();
    const Seen next = seen_from(best.position + step * (move[0] * a + move[1] * b));
    if (next.place.distance < best.place.distance)
      best = next;
  }
  return { best.place.distance, { from.vesicle, from.other },
    { best.position, best.place.position } };
}

std::optional<Gap> Proximity::smallest() const
{
  // Of each pair the nearest vertex; those that can't have the smallest gap are left out.
  std::vector<const NearVertex*> first;
  double least = std::numeric_limits<double>::infinity(), edge = 0;
  for (const NearVertex& near : near_)
  {
    if (first.empty() || first.back()->vesicle != near.vesicle || first.back()->other != near.other)
      first.push_back(&near);
    else if (near.place.distance < first.back()->place.distance)
      first.back() = &near;
    least = std::min(least, near.place.distance);
    edge = std::max(edge, edge_of(*sides_[near.vesicle].surface));
  }
  if (first.empty())
    return {};
  std::erase_if(
    first, [&](const NearVertex* near) { return near->place.distance > least + edge / 2; });
  std::vector<Gap> gaps(first.size());
  parallel_for(first.size(), [&](std::size_t i) { gaps[i] = between(*first[i]); });
  return *std::min_element(
    gaps.begin(), gaps.end(), [](const Gap& a, const Gap& b) { return a.distance < b.distance; });
}

std::vector<double> distances(const Proximity& proximity)
{
  std::vector<double> least(proximity.sides(), std::numeric_limits<double>::infinity());
  for (const Proximity::NearVertex& near : proximity.near())
    for (const std::size_t v : { near.vesicle, near.other })
      least[v] = std::min(least[v], near.place.distance);
  return least;
}

}
