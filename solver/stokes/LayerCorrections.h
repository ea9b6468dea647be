#pragma once
// The single layer's near and singular rules less what the regular rule gives there: a sparse matrix.

#include "solver/stokes/LayerRules.h"

namespace vesicle
{

/// Between the nodes and the vertices of one surface at one shape, group by group of vertices, as the
/// kernels make and use the blocks. `rules` must outlive it.
class LayerCorrections
{
public:
  explicit LayerCorrections(const LayerRules& rules);
  /// Sums of a group for its nodes, nodes · stokeslet_components · stokeslet_lanes; 0 at first.
  double* group(int number) { return blocks_.data() + start_[number]; }

  /// To the velocities at the vertices what f = Σ N_k f_k adds: rows first … of `velocity`. Threads
  /// share the groups; results do not depend on their number.
  void add(const Eigen::VectorXd& density, int first, Points& velocity) const;

private:
  const LayerRules* rules_;
  std::vector<std::size_t> start_; ///< of each group
  std::vector<double> blocks_;
};

}
