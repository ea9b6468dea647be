#pragma once
// The single layer of the Stokeslet, collocated at the nodes: u(x_i) = Σ_k S_ik f_k for a nodal
// force density f, S_ik = (1/8πμ) ∮ G(x_i, y) N_k(y) dS(y), G = I/r + X Xᵀ/r³, paper (11)–(13) with
// μ = 1.

#include "solver/geometry/Surface.h"

#include <vector>

namespace vesicle
{

/// 3N by 3N, row-major; rows and columns have 3 entries a node.
using DenseMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

struct StokesletSources;

class StokesletMatrix
{
public:
  /// Tables for the connectivity of `basis`. Elements that don't touch the node use the triangle
  /// rule with `quadrature` points; those that do use a Duffy rule, whose radial part is exact for
  /// flat elements.
  StokesletMatrix(const Basis& basis, int quadrature);

  const BasisTable& table() const { return regular_; }

  /// Fills `matrix` (resized if need be) for nodes at `points`; `surface` is evaluate(table(),
  /// points). Threads share the rows; the result does not depend on their number.
  void assemble(const Points& points, const SurfacePoints& surface, DenseMatrix& matrix) const;

private:
  void assemble_block(const Points& points, const StokesletSources& sources,
    const SurfacePoints& singular, int first, DenseMatrix& matrix) const;

  BasisTable regular_;
  BasisTable singular_;             ///< Duffy rows, grouped by node
  std::vector<int> singular_start_; ///< first Duffy row of each node
  std::vector<int> first_row_;      ///< first regular row of each element
  AdjacencyList node_elements_;     ///< elements around each node
};

/// y = A x with A row-major; rows in parallel, each summed in a fixed order.
void multiply(const DenseMatrix& A, const Eigen::VectorXd& x, Eigen::VectorXd& y);

}
