#include "solver/stokes/ClusterTree.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

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
// near, and only in part: what they leave in all is measured to be a fifth of it.
int points_along(double half, double distance, double tolerance)
{
  constexpr double nearest_to_all = 5;
  if (half <= 1e-12 * distance)
    return 1;
  const double t = distance / half, rho = t + std::sqrt(t * t - 1);
  return std::max(
    1, static_cast<int>(std::ceil(-std::log(nearest_to_all * tolerance) / std::log(rho))));
}

struct Builder
{
  const RowVectors& points;
  double tolerance;
  int multiple;
  ClusterTree& tree;

  Cluster cluster(int begin, int end) const;
  void split(int c);
};

Cluster Builder::cluster(int begin, int end) const
{
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (int i = begin; i < end; ++i)
    mean += points.row(tree.order[i]).transpose();
  mean /= end - begin;
  if (!mean.allFinite()) // a step gone wrong, which is found out later: nothing is far from it
    return { begin, end, { Cluster::no_child, Cluster::no_child }, mean, Eigen::Vector3d::Zero(),
      Eigen::Matrix3d::Identity(), { 1, 1, 1 } };
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (int i = begin; i < end; ++i)
  {
    const Eigen::Vector3d d = points.row(tree.order[i]).transpose() - mean;
    spread += d * d.transpose();
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
  axes.computeDirect(spread);
  Cluster c{ begin, end, { Cluster::no_child, Cluster::no_child }, mean, Eigen::Vector3d::Zero(),
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
  for (int side = 0; side < 3; ++side)
    c.grid[side] = points_along(c.half[side], far_distance * c.radius(), tolerance);
  return c;
}

// In two halves across the longest side.
void Builder::split(int c)
{
  const Cluster whole = tree.clusters[c];
  const int middle = whole.begin + whole.points() / 2 / multiple * multiple;
  if (whole.points() <= whole.proxies() || middle == whole.begin || !whole.centre.allFinite())
    return;
  Eigen::Index longest;
  whole.half.maxCoeff(&longest);
  const Eigen::Vector3d along = whole.axes.col(longest);
  std::nth_element(tree.order.begin() + whole.begin, tree.order.begin() + middle,
    tree.order.begin() + whole.end,
    [&](int a, int b) { return points.row(a).dot(along) < points.row(b).dot(along); });
  for (const auto& [begin, end] :
    { std::pair{ whole.begin, middle }, std::pair{ middle, whole.end } })
  {
    const int child = static_cast<int>(tree.clusters.size());
    tree.clusters[c].child[begin == whole.begin ? 0 : 1] = child;
    tree.clusters.push_back(cluster(begin, end));
    split(child);
  }
}

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

ClusterTree::ClusterTree(const RowVectors& points, double tolerance, int multiple)
  : order(points.rows())
{
  std::iota(order.begin(), order.end(), 0);
  Builder builder{ points, tolerance, multiple, *this };
  clusters.push_back(builder.cluster(0, static_cast<int>(order.size())));
  builder.split(0);
}

bool is_far(const Cluster& target, const Cluster& source)
{
  return (target.centre - source.centre).norm() - target.radius() >= far_distance * source.radius();
}

}
