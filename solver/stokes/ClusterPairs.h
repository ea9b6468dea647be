#pragma once
// Which clusters of sources act on which clusters of targets, so that every pair of points is counted
// once.

#include "solver/stokes/ClusterTree.h"

namespace vesicle
{

/// Of every cluster of targets, the clusters of sources that act on it: from afar, or leaves.
///
/// Whichever of the two isn't a leaf is compact and far from the other, so that its proxies may stand for it.
std::vector<std::vector<int>> acting_clusters(
  const ClusterTree& targets, const ClusterTree& sources);

}
