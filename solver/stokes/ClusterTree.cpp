#include "solver/stokes/ClusterTree.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

namespace vesicle
{

namespace
{

Eigen::VectorXd chebyshev_points(int n)
{
  return Eigen::VectorXd::NullaryExpr(
    n, [n](Eigen::Index i) { return std::cos(std::numbers::pi * (i + 0.5) / n); });
}

// Interpolation at n Chebyshev points converges as ρ⁻ⁿ, ρ of the ellipse through the nearest
// singularity (Trefethen, Approximation Theory and Approximation Practice, 8). Few clusters are that
// near, and only in part: what they leave in all is measured to be a third of it at most.
int points_along(double half, double distance, double tolerance)
{
  constexpr double nearest_to_all = 3;
  if (half <= 1e-12 * distance)
    return 1;
  const double t = distance / half, rho = t + std::sqrt(t * t - 1);
  return std::max(
    1, static_cast<int>(std::ceil(-std::log(nearest_to_all * tolerance) / std::log(rho))));
}

struct Builder
{
  const RowVectors& points;
  const std::vector<int>& first;
  double tolerance;
  int multiple;
  ClusterTree& tree;

  Cluster cluster(int begin, int end) const;
  int add(int begin, int end);
  int add_bodies(int begin, std::span<int> bodies);
  void split(int c);
  void split_bodies(int c, std::span<int> bodies);
};

Cluster Builder::cluster(int begin, int end) const
{
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (int i = begin; i < end; ++i)
    mean += points.row(tree.order[i]).transpose();
  mean /= end - begin;
  if (!mean.allFinite()) // a step gone wrong, which is found out later: nothing is far from it
    return { begin, end, { Cluster::no_child, Cluster::no_child }, mean, Eigen::Vector3d::Zero(), 0,
      Eigen::Matrix3d::Identity(), { 1, 1, 1 } };
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (int i = begin; i < end; ++i)
  {
    const Eigen::Vector3d d = points.row(tree.order[i]).transpose() - mean;
    spread += d * d.transpose();
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
  axes.computeDirect(spread);
  Cluster c{ begin, end, { Cluster::no_child, Cluster::no_child }, mean, Eigen::Vector3d::Zero(), 0,
    axes.eigenvectors().rowwise().reverse(), { 1, 1, 1 } };
  Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::max()), high = -low;
  for (int i = begin; i < end; ++i)
  {
    const Eigen::Vector3d at = c.axes.transpose() * (points.row(tree.order[i]).transpose() - mean);
    low = low.cwiseMin(at);
    high = high.cwiseMax(at);
  }
  c.centre += c.axes * (low + high) / 2;
  c.half = (high - low) / 2;
  for (int i = begin; i < end; ++i)
    c.radius = std::max(c.radius, (points.row(tree.order[i]).transpose() - c.centre).norm());
  for (int side = 0; side < 3; ++side)
    c.grid[side] = points_along(c.half[side], far_distance * c.radius, tolerance);
  return c;
}

int Builder::add(int begin, int end)
{
  tree.clusters.push_back(cluster(begin, end));
  return static_cast<int>(tree.clusters.size()) - 1;
}

// In two halves across the longest side.
void Builder::split(int c)
{
  const Cluster whole = tree.clusters[c];
  const int middle = whole.begin + whole.points() / 2 / multiple * multiple;
  if (!whole.worth_proxies() || middle == whole.begin || !whole.centre.allFinite())
    return;
  const Eigen::Vector3d along = whole.longest();
  std::nth_element(tree.order.begin() + whole.begin, tree.order.begin() + middle,
    tree.order.begin() + whole.end,
    [&](int a, int b) { return points.row(a).dot(along) < points.row(b).dot(along); });
  for (const auto& [side, begin, end] :
    { std::tuple{ 0, whole.begin, middle }, std::tuple{ 1, middle, whole.end } })
  {
    const int child = add(begin, end);
    tree.clusters[c].child[side] = child;
    split(child);
  }
}

// Of their points, in the order from `begin` on.
int Builder::add_bodies(int begin, std::span<int> bodies)
{
  int end = begin;
  for (const int body : bodies)
    for (int i = first[body]; i < first[body + 1]; ++i)
      tree.order[end++] = i;
  const int c = add(begin, end);
  if (bodies.size() == 1)
    split(c);
  else
    split_bodies(c, bodies);
  return c;
}

// The same between bodies, by their centres.
void Builder::split_bodies(int c, std::span<int> bodies)
{
  const Cluster whole = tree.clusters[c];
  const Eigen::Vector3d along = whole.longest();
  const auto place = [&](int body) -> double
  { return (points.middleRows(first[body], first[body + 1] - first[body]) * along).mean(); };
  std::vector<std::pair<double, int>> places;
  for (const int body : bodies)
    places.emplace_back(place(body), body);
  const std::size_t half = bodies.size() / 2;
  if (whole.centre.allFinite())
    std::nth_element(places.begin(), places.begin() + half, places.end());
  std::transform(
    places.begin(), places.end(), bodies.begin(), [](const auto& at) { return at.second; });
  int begin = whole.begin;
  for (const int side : { 0, 1 })
  {
    const int child = add_bodies(begin, side == 0 ? bodies.first(half) : bodies.subspan(half));
    tree.clusters[c].child[side] = child;
    begin = tree.clusters[child].end;
  }
}

}

Eigen::Vector3d Cluster::longest() const
{
  Eigen::Index side;
  half.maxCoeff(&side);
  return axes.col(side);
}

RowVectors Cluster::proxy_positions() const
{
  std::array<Eigen::VectorXd, 3> along;
  for (int side = 0; side < 3; ++side)
    along[side] = half[side] * chebyshev_points(grid[side]);
  RowVectors positions(proxies(), 3);
  for (int i = 0; i < proxies(); ++i)
    positions.row(i) << along[0][i % grid[0]], along[1][i / grid[0] % grid[1]],
      along[2][i / grid[0] / grid[1]];
  return (positions * axes.transpose()).rowwise() + centre.transpose();
}

// Each weight, ∏ (x − x_j) / (x_k − x_j) over j ≠ k, from the products over j < k and over j > k.
Eigen::MatrixXd Cluster::weights(int side, const RowVectors& points) const
{
  const int n = grid[side];
  Eigen::MatrixXd weight = Eigen::MatrixXd::Ones(points.rows(), n);
  if (n == 1)
    return weight;
  const Eigen::VectorXd at = (points.rowwise() - centre.transpose()) * axes.col(side) / half[side],
                        node = chebyshev_points(n);
  Eigen::ArrayXd below = Eigen::ArrayXd::Ones(points.rows()), above = below;
  for (int k = 0, last = n - 1; k < n; ++k, --last)
  {
    weight.col(k).array() *= below;
    below *= at.array() - node[k];
    weight.col(last).array() *= above;
    above *= at.array() - node[last];
  }
  for (int k = 0; k < n; ++k)
  {
    double divisor = 1;
    for (int j = 0; j < n; ++j)
      divisor *= j == k ? 1 : node[k] - node[j];
    weight.col(k) /= divisor;
  }
  return weight;
}

ClusterTree::ClusterTree(
  const RowVectors& points, std::vector<int> first, double tolerance, int multiple)
  : order(points.rows())
{
  if (first.empty())
    first = { 0, static_cast<int>(points.rows()) };
  std::vector<int> bodies(first.size() - 1);
  std::iota(bodies.begin(), bodies.end(), 0);
  Builder{ points, first, tolerance, multiple, *this }.add_bodies(0, bodies);
}

bool is_far(const Cluster& target, const Cluster& source)
{
  return (target.centre - source.centre).norm() - target.radius >= far_distance * source.radius;
}

}
