#pragma once
// Sums of point forces at less than one operation a pair: clusters of sources act on clusters of
// targets from afar through proxies (ClusterTree.h).

#include "solver/stokes/PointSum.h"
#include "solver/stokes/ProxyTree.h"

#include <memory>

namespace vesicle
{

/// No target may be a source. Threads share clusters and targets; results do not depend on their
/// number.
class TreeSum final : public PointSum
{
public:
  /// `tolerance` is what Precision::full leaves, about, root mean square and relative to the velocity.
  /// With Precision::single clusters leave no less than single_precision_error, and so does rounding.
  TreeSum(const RowVectors& sources, const Points& targets, double tolerance);
  void add(const RowVectors& forces, Precision precision, Points& velocity) const override;

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
    Tree(const RowVectors& sources, const Points& targets, double tolerance);
    void add(const RowVectors& forces, Points& velocity) const;

    std::unique_ptr<ProxyTree<Real>> sources, targets;
    Eigen::Array<Real, Eigen::Dynamic, 3> source_positions;
    std::vector<Real> target_positions;        ///< x, y, z of sum_lanes rows, and so on
    std::vector<std::vector<RowRange>> acting; ///< on each cluster of targets that is acted on
    std::vector<Task> tasks;
  };
  Tree<double> full_;
  Tree<float> single_;
};

}
