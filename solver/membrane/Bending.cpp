#include "solver/membrane/Bending.h"

#include <vector>

namespace vesicle
{

double bending_energy(const CotanGeometry& geometry, const Curvature& curvature)
{
  return 2 * geometry.vertex_area.dot(curvature.mean.cwiseAbs2());
}

Eigen::VectorXd bending_density(const Curvature& c)
{
  return 2 * c.laplacian_mean.array() +
    4 * c.mean.array() * (c.mean.array().square() - c.gauss.array());
}

SparseMatrix bending_matrix(const CotanGeometry& geometry, const Curvature& c)
{
  const SparseMatrix& L = geometry.laplacian;
  // H = −½ 𝒩ᵀ(L ⊗ I₃) x: row i holds −½ L_ij n_i.
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < L.rows(); ++i)
    for (SparseMatrix::InnerIterator it(L, i); it; ++it)
      for (int d = 0; d < 3; ++d)
        entries.emplace_back(i, 3 * it.col() + d, -0.5 * it.value() * c.normal(i, d));
  SparseMatrix mean_curvature(L.rows(), 3 * L.rows());
  mean_curvature.setFromTriplets(entries.begin(), entries.end());

  SparseMatrix from_mean = 2 * L;
  const Eigen::VectorXd local = 4 * (c.mean.array().square() - c.gauss.array());
  for (int i = 0; i < L.rows(); ++i)
    from_mean.coeffRef(i, i) += local[i];
  return from_mean * mean_curvature;
}

SparseMatrix normal_part(const SparseMatrix& response, const Points& normal)
{
  SparseMatrix result = response;
  for (int i = 0; i < result.rows(); ++i)
  {
    // The entries of a row come in blocks of three, one block a node.
    double* value = result.valuePtr() + result.outerIndexPtr()[i];
    const int* column = result.innerIndexPtr() + result.outerIndexPtr()[i];
    const int count = result.outerIndexPtr()[i + 1] - result.outerIndexPtr()[i];
    for (int k = 0; k + 2 < count; k += 3)
    {
      const auto n = normal.row(column[k] / 3);
      Eigen::Map<Eigen::RowVector3d> block(value + k);
      block = (block.dot(n) * n).eval();
    }
  }
  return result;
}

}
