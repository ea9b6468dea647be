#pragma once
// Points in clusters of clusters, each in a box along its own axes. What a cluster's points do far
// away, fewer proxy points do: a grid of Chebyshev points in its box, through which the kernel is
// interpolated (L. Wang, R. Krasny, S. Tlupova, Commun. Comput. Phys. 28 (2020) 1415, with boxes that
// follow the surface: thin ones need few points across).

#include "solver/surface/SurfaceIntegrals.h"

#include <array>
#include <vector>

namespace vesicle
{

/// A cluster is far from what is this many times its radius away. Measured on surfaces and in a
/// volume: from 1.5 to 3 the time hardly changes.
inline constexpr double far_distance = 2.5;

struct Cluster
{
  int begin, end;               ///< its points in ClusterTree::order
  std::array<int, 2> child;     ///< or no_child
  Eigen::Vector3d centre, half; ///< of the box, and half its sides
  double radius;                ///< of its points around the centre
  Eigen::Matrix3d axes;         ///< of its sides, one a column
  std::array<int, 3> grid;      ///< proxy points along the sides

  static constexpr int no_child = -1;
  int points() const { return end - begin; }
  int proxies() const { return grid[0] * grid[1] * grid[2]; }
  /// Of one body and not worth proxies: smaller clusters are never needed.
  bool leaf() const { return child[0] == no_child; }
  /// So much fewer proxies than points pay for the way to them and back.
  bool worth_proxies() const { return 3 * proxies() < 2 * points(); }
  /// Its proxies are used.
  bool compact() const { return !leaf() && worth_proxies(); }
  Eigen::Vector3d longest() const; ///< the axis of its longest side
  /// Proxies by 3; along side 0 first.
  RowVectors proxy_positions() const;
  /// What the grid's points along a side weigh in the interpolation to points: #points by grid[side].
  Eigen::MatrixXd weights(int side, const RowVectors& points) const;
};

/// Clusters lie after those that contain them, the first contains all points; leaves lie in the order of
/// their points. The proxies' error is about `tolerance` of what the cluster does at far_distance and beyond.
struct ClusterTree
{
  /// `first`: of each body's points, which clusters hold as a whole or none of another's, and the number
  /// of all; empty: of one body. Clusters of one body begin at a multiple of `multiple` in it.
  ClusterTree(const RowVectors& points, std::vector<int> first, double tolerance, int multiple);

  std::vector<int> order; ///< the points' numbers
  std::vector<Cluster> clusters;
};

/// All of `target` is so far from `source` that the source's proxies may stand for its points.
bool is_far(const Cluster& target, const Cluster& source);

}
