#pragma once
// The double layer, collocated at the vertices of one or several surfaces and applied without its
// matrix:
// (K u)_i(x) = (3/4π) PV ∮ X_i X_j (X·n) u_j/r⁵ dS(y), X = y − x, n outward.

#include "solver/stokes/LayerSum.h"

namespace vesicle
{

/// At the operator's shape. The surfaces' rules must outlive it, the operator need not.
///
/// On a surface itself u(x) is taken out of u, K u = K (u − u(x)) + u(x)/2, so that rigid motions are
/// exact: K u = u/2. What is left goes with 1/r, as the single layer does, and the same rules hold.
class DoubleLayer
{
public:
  /// `factors`: of each surface's layer.
  DoubleLayer(const StokesOperator& layer, const std::vector<double>& factors,
    const MakePointSum& make_sum = direct_sum);

  static std::unique_ptr<const PointSum> direct_sum(const PointPlaces& places);

  /// Σ_s factor_s K_s u at all vertices, 3N: u = Σ N_k u_k with 3 numbers a node of each surface,
  /// `at_vertices` (3N) what that is at the vertices; `allowed`: an error of the sum's (PointSum). Threads share points and vertices; results do
  /// not depend on their number.
  Eigen::VectorXd apply(const std::vector<Eigen::VectorXd>& nodal,
    const Eigen::VectorXd& at_vertices, double allowed = 0) const;

private:
  struct Source
  {
    const BasisTable* table;
    RowVectors normal;             ///< at the table's rows: 3/4π n dS
    int first_vertex, first_point; ///< among all
    SurfaceCorrections corrections;
    double factor;
    RowVectors
      own; ///< ½ − the rules' K of constants at its vertices: 3 by 3 each, one below the other
  };
  static Eigen::Matrix<double, Eigen::Dynamic, 6> stresslets(
    const Source& source, const Points& nodal);
  static RowVectors own_blocks(const Source& source, const PointSum& sum, int vertices);

  std::vector<Source> sources_;
  std::unique_ptr<const PointSum> sum_;
  int points_ = 0, vertices_ = 0;
};

}
