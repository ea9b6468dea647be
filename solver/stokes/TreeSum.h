#pragma once
// Sums over points at less than one operation a pair: clusters of sources act on clusters of targets
// from afar through proxies (ClusterTree.h).

#include "solver/stokes/PointSum.h"
#include "solver/stokes/ProxyTree.h"

#include <memory>

namespace vesicle
{

/// No target may be a source. Threads share clusters and targets; results do not depend on their
/// number.
template<PointKind kind>
class TreePointSum final : public PointSum
{
public:
  /// `tolerance` is the best that it leaves. There are trees for greater errors, too, in single precision.
  TreePointSum(const PointPlaces& places, double tolerance);
  void add(const Eigen::Ref<const Eigen::MatrixXd>& strengths, double allowed,
    Points& velocity) const override;

private:
  /// Targets and sources that stand for clusters, one acting on the other.
  struct Task
  {
    int first_block, blocks;
    int acting; ///< number of the ranges of sources
  };
  template<class Real>
  struct Tree
  {
    Tree(const PointPlaces& places, double tolerance);
    void add(const Eigen::Ref<const Eigen::MatrixXd>& strengths, Points& velocity) const;

    std::unique_ptr<ProxyTree<Real>> sources, targets;
    double unit; ///< of velocities
    typename PointGrid<Real>::Positions source_positions;
    std::vector<Coordinate<Real>> target_positions; ///< x, y, z of sum_lanes rows, and so on
    std::vector<std::vector<RowRange>> acting;      ///< on each cluster of targets that is acted on
    std::vector<Task> tasks;
  };
  Tree<double> best_;
  Tree<float> fine_, coarse_;
};
using TreeSum = TreePointSum<PointKind::force>;

extern template class TreePointSum<PointKind::force>;
extern template class TreePointSum<PointKind::stresslet>;
extern template class TreePointSum<PointKind::force_image>;
extern template class TreePointSum<PointKind::stresslet_image>;

}
