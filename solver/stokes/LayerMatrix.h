#pragma once
// The single layer between the nodes of one surface and the vertices of all, stored: for meshes on
// which reading it costs less than its sums.

#include "solver/stokes/kernels/StokesletKernel.h"

#include <Eigen/Core>

#include <vector>

namespace vesicle
{

/// Of all vectors at the nodes of a surface, f = Σ N_k f_k: the velocities at all vertices. The blocks
/// are symmetric, 6 numbers a vertex and node, and lie as the kernels make and use them: groups of
/// stokeslet_lanes vertices, one a lane.
class LayerMatrix
{
public:
  /// Room for `groups` groups of targets, `nodes` nodes and all vertices; what is there is kept.
  void resize(int groups, int nodes, int vertices);
  /// The sums of a group, nodes · stokeslet_components · stokeslet_lanes.
  double* group(int number);
  /// The vertices of a group's lanes; −1: none.
  int* targets(int number);

  /// 3 numbers a vertex from 3 a node. Threads share the groups; results do not depend on their number.
  Eigen::VectorXd operator*(const Eigen::VectorXd& density) const;

private:
  static constexpr std::size_t lanes = stokeslet_lanes, node_stride = stokeslet_components * lanes;
  std::vector<double> blocks_;
  std::vector<int> targets_;
  int nodes_ = 0, vertices_ = 0;
};

}
