#include "solver/stokes/ClusterPairs.h"

namespace vesicle
{

namespace
{

struct Traversal
{
  const ClusterTree &targets, &sources;
  std::vector<std::vector<int>>& acting;

  void meet(int target, int source)
  {
    const Cluster &t = targets.clusters[target], &s = sources.clusters[source];
    const bool whole_target = t.leaf() || (t.compact() && is_far(s, t)),
               whole_source = s.leaf() || (s.compact() && is_far(t, s));
    if (whole_target && whole_source)
      acting[target].push_back(source);
    else if (whole_target || (!whole_source && s.radius > t.radius))
      for (const int child : s.child)
        meet(target, child);
    else
      for (const int child : t.child)
        meet(child, source);
  }
};

}

std::vector<std::vector<int>> acting_clusters(
  const ClusterTree& targets, const ClusterTree& sources)
{
  std::vector<std::vector<int>> acting(targets.clusters.size());
  Traversal{ targets, sources, acting }.meet(0, 0);
  return acting;
}

}
