#pragma once
// What stands for the clusters of a tree: rows of numbers at the points, in the tree's order, and at
// the proxies of the clusters that act or are acted on from afar.

#include "solver/stokes/ProxyInterpolation.h"

namespace vesicle
{

/// Rows of one matrix.
struct RowRange
{
  int first, count;
};

template<class Real>
class ProxyTree
{
public:
  /// `used`: of every cluster, whether its proxies are wanted. Leaves and proxies begin at multiples of
  /// `multiple`; rows between them lie where the row before them does.
  ProxyTree(ClusterTree tree, const RowVectors& points, std::vector<bool> used, int multiple);

  /// Of all rows.
  const RowVectors& positions() const { return positions_; }
  /// A cluster's proxies, or the points of a leaf.
  RowRange rows(int cluster) const;

  /// Forces at the rows: those of the points, in their own order, and their clusters' proxies'.
  ThreeColumns<Real> up(const RowVectors& forces) const;
  /// Adds the velocities at the rows to those of the points, in their own order, the proxies'
  /// interpolated on the way.
  void down(ThreeColumns<Real> rows, Points& velocities) const;

private:
  /// A used cluster and its halves.
  struct Proxies
  {
    RowRange rows;
    std::array<RowRange, 2> half;
    std::array<ProxyInterpolation<Real>, 2> interpolation;
  };
  void place_points(int multiple);

  ClusterTree tree_;
  std::vector<int> point_row_; ///< of each point in the tree's order, and the number of their rows
  std::vector<int> first_proxy_; ///< row, of each cluster
  RowVectors positions_;
  std::vector<std::vector<Proxies>> levels_; ///< the whole first
};

extern template class ProxyTree<float>;
extern template class ProxyTree<double>;

}
