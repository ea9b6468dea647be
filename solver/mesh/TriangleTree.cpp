#include "solver/mesh/TriangleTree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace vesicle
{

// By the regions in which the origin can lie (C. Ericson, Real-Time Collision Detection, 2005,
// section 5.1.5).
Vector3 nearest_weights(const Vector3& a, const Vector3& b, const Vector3& c)
{
  const Vector3 ab = b - a, ac = c - a;
  const double d1 = -ab.dot(a), d2 = -ac.dot(a);
  if (d1 <= 0 && d2 <= 0)
    return { 1, 0, 0 };
  const double d3 = -ab.dot(b), d4 = -ac.dot(b);
  if (d3 >= 0 && d4 <= d3)
    return { 0, 1, 0 };
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0)
  {
    const double s = d1 / (d1 - d3);
    return { 1 - s, s, 0 };
  }
  const double d5 = -ab.dot(c), d6 = -ac.dot(c);
  if (d6 >= 0 && d5 <= d6)
    return { 0, 0, 1 };
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0)
  {
    const double s = d2 / (d2 - d6);
    return { 1 - s, 0, s };
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6)
  {
    const double s = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return { 0, 1 - s, s };
  }
  return Vector3(va, vb, vc) / (va + vb + vc);
}

namespace
{
constexpr int leaf_size = 4;
/// The line shan't slip through between two triangles, nor past a box of no thickness.
constexpr double line_rounding = 1e-9;

/// Does the line x + s d, |s| ≤ reach, meet the box? By the slabs between its faces.
bool meets(const Eigen::AlignedBox3d& box, const Vector3& x, const Vector3& d, double reach)
{
  double low = -reach, high = reach;
  for (int k = 0; k < 3; ++k)
  {
    const double a = box.min()[k] - x[k], b = box.max()[k] - x[k];
    if (d[k] == 0)
    {
      if (a > 0 || b < 0)
        return false;
      continue;
    }
    low = std::max(low, std::min(a / d[k], b / d[k]));
    high = std::min(high, std::max(a / d[k], b / d[k]));
  }
  return low <= high + line_rounding * reach;
}

/// Barycentric weights of the point where the line through the origin along d meets triangle a, b,
/// c: volumes of the edges with d. Nothing if it passes by or runs along the triangle.
std::optional<Vector3> line_weights(
  const Vector3& d, const Vector3& a, const Vector3& b, const Vector3& c)
{
  const Vector3 volumes(d.dot(b.cross(c)), d.dot(c.cross(a)), d.dot(a.cross(b)));
  const double sum = volumes.sum();
  if (!(sum > 0) || volumes.minCoeff() < -line_rounding * sum)
    return std::nullopt;
  return volumes / sum;
}
}

TriangleTree::TriangleTree(TriangleMesh mesh, Points facings)
  : mesh_(std::move(mesh)), facings_(std::move(facings)), order_(mesh_.triangles.rows())
{
  std::iota(order_.begin(), order_.end(), 0);
  Points centres(mesh_.triangles.rows(), 3);
  for (int t = 0; t < centres.rows(); ++t)
    centres.row(t) = mesh_.points(mesh_.triangles.row(t), Eigen::all).colwise().mean();
  build(0, static_cast<int>(order_.size()), centres);
}

/// Halves the triangles at the median of their centres along the longest side of the centres' box.
void TriangleTree::build(int first, int last, const Points& centres)
{
  const int number = static_cast<int>(nodes_.size());
  Node node{ {}, -1, first, last };
  Eigen::AlignedBox3d spread;
  for (int i = first; i < last; ++i)
  {
    spread.extend(centres.row(order_[i]).transpose());
    for (const int corner : mesh_.triangles.row(order_[i]))
      node.box.extend(mesh_.points.row(corner).transpose());
  }
  nodes_.push_back(node);
  if (last - first <= leaf_size)
    return;
  int axis = 0;
  spread.sizes().maxCoeff(&axis);
  const int middle = (first + last) / 2;
  std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
    [&](int l, int r) { return std::pair(centres(l, axis), l) < std::pair(centres(r, axis), r); });
  build(first, middle, centres);
  nodes_[number].right = static_cast<int>(nodes_.size());
  build(middle, last, centres);
}

void TriangleTree::visit_nearest(int number, const Vector3& x, Hit& best) const
{
  const Node& node = nodes_[number];
  if (node.right >= 0)
  {
    std::array<std::pair<double, int>, 2> children;
    for (int k = 0; k < 2; ++k)
    {
      const int child = k == 0 ? number + 1 : node.right;
      children[k] = { nodes_[child].box.squaredExteriorDistance(x), child };
    }
    std::ranges::sort(children);
    for (const auto& [squared_distance, child] : children)
      if (squared_distance < best.squared_distance)
        visit_nearest(child, x, best);
    return;
  }
  for (int i = node.first; i < node.last; ++i)
  {
    const auto [a, b, c] = corners(mesh_, order_[i], x);
    const Vector3 weights = nearest_weights(a, b, c);
    const double squared_distance =
      (weights[0] * a + weights[1] * b + weights[2] * c).squaredNorm();
    if (squared_distance < best.squared_distance)
      best = { order_[i], weights, squared_distance };
  }
}

void TriangleTree::visit_intersections(
  int number, const Vector3& x, const Vector3& direction, Hit& best) const
{
  const Node& node = nodes_[number];
  if (!meets(node.box, x, direction, std::sqrt(best.squared_distance)))
    return;
  if (node.right >= 0)
  {
    visit_intersections(number + 1, x, direction, best);
    visit_intersections(node.right, x, direction, best);
    return;
  }
  for (int i = node.first; i < node.last; ++i)
  {
    const auto [a, b, c] = corners(mesh_, order_[i], x);
    const auto weights = line_weights(direction, a, b, c);
    if (!weights || facings_.row(order_[i]).dot(direction) <= 0)
      continue;
    const double squared_distance =
      ((*weights)[0] * a + (*weights)[1] * b + (*weights)[2] * c).squaredNorm();
    if (squared_distance < best.squared_distance)
      best = { order_[i], *weights, squared_distance };
  }
}

TriangleTree::Hit TriangleTree::nearest(const Vector3& x) const
{
  Hit best;
  best.squared_distance = std::numeric_limits<double>::infinity();
  visit_nearest(0, x, best);
  return best;
}

TriangleTree::Hit TriangleTree::intersect(const Vector3& x, const Vector3& direction) const
{
  Hit best;
  best.squared_distance = nodes_[0].box.diagonal().squaredNorm();
  visit_intersections(0, x, direction, best);
  return best;
}

void TriangleTree::visit_overlaps(const std::function<bool(int, int)>& visit) const
{
  visit_within(0, visit);
}

bool TriangleTree::visit_within(int number, const VisitPair& visit) const
{
  const Node& node = nodes_[number];
  if (node.right >= 0)
    return visit_within(number + 1, visit) || visit_within(node.right, visit) ||
      visit_between(number + 1, node.right, visit);
  for (int i = node.first; i < node.last; ++i)
    for (int j = i + 1; j < node.last; ++j)
      if (box_of(order_[i]).intersects(box_of(order_[j])) && visit(order_[i], order_[j]))
        return true;
  return false;
}

bool TriangleTree::visit_between(int l, int r, const VisitPair& visit) const
{
  const Node &left = nodes_[l], &right = nodes_[r];
  if (!left.box.intersects(right.box))
    return false;
  if (left.right >= 0 && (right.right < 0 || left.last - left.first >= right.last - right.first))
    return visit_between(l + 1, r, visit) || visit_between(left.right, r, visit);
  if (right.right >= 0)
    return visit_between(l, r + 1, visit) || visit_between(l, right.right, visit);
  for (int i = left.first; i < left.last; ++i)
    for (int j = right.first; j < right.last; ++j)
      if (box_of(order_[i]).intersects(box_of(order_[j])) && visit(order_[i], order_[j]))
        return true;
  return false;
}

Eigen::AlignedBox3d TriangleTree::box_of(int triangle) const
{
  Eigen::AlignedBox3d box;
  for (const Vector3& corner : corners(mesh_, triangle))
    box.extend(corner);
  return box;
}

}
