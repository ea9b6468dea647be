#pragma once
// The single layer between the nodes of all surfaces and the vertices of all, applied without its
// matrix: densities at the points of the regular rules, a sum over all pairs of points and vertices,
// and sparse corrections near and at each surface's own vertices and near other surfaces.

#include "solver/stokes/PointSum.h"
#include "solver/stokes/StokesOperator.h"

#include <memory>
#include <optional>

namespace vesicle
{

/// At the operator's shape. The surfaces' rules must outlive it, the operator need not.
class LayerSum
{
public:
  /// `make_sum`: what adds up all pairs of points and vertices.
  explicit LayerSum(const StokesOperator& layer, const MakePointSum& make_sum = direct_sum);

  static std::unique_ptr<const PointSum> direct_sum(const PointPlaces& places);

  /// Velocities at all vertices, 3N, of f = Σ N_k f_k: 3 numbers a node of each surface; `allowed`: an
  /// error of the sum's (PointSum). Threads share points and vertices; results do not depend on their number.
  Eigen::VectorXd apply(const std::vector<Eigen::VectorXd>& densities, double allowed = 0) const;

private:
  struct Source
  {
    const BasisTable* table;
    Eigen::VectorXd weight;        ///< of the table's rows; contains dS/8πμ
    int first_vertex, first_point; ///< among all
    SurfaceCorrections corrections;
  };
  std::vector<Source> sources_;
  std::unique_ptr<const PointSum> sum_;
  int points_ = 0, vertices_ = 0;
};

}
