#include "solver/membrane/HelfrichBending.h"

#include "solver/membrane/PaperScheme.h"
#include "solver/surface/FittedCurvature.h"

#include <Eigen/SparseCholesky>

#include <vector>

namespace vesicle
{

std::unique_ptr<const MembraneTerm> make_bending(const SurfaceSpace& space, double c0)
{
  switch (space.curvature())
  {
    case VertexCurvature::weak:
      return std::make_unique<SmoothBending>(c0);
    case VertexCurvature::cotan:
      return std::make_unique<CotanBending>(c0);
    case VertexCurvature::paper:
      return std::make_unique<PaperBending>(c0);
    case VertexCurvature::fitted:
      break;
  }
  return std::make_unique<FittedBending>(c0);
}

namespace
{

// −K 𝒩ᵀ: the response to the normal velocities of the nodes.
SparseMatrix along_normals(const SparseMatrix& K, const Points& normal)
{
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(3 * K.nonZeros());
  for (int i = 0; i < K.rows(); ++i)
    for (SparseMatrix::InnerIterator it(K, i); it; ++it)
      for (int d = 0; d < 3; ++d)
        entries.emplace_back(i, 3 * it.col() + d, -it.value() * normal(it.col(), d));
  SparseMatrix R(K.rows(), 3 * K.cols());
  R.setFromTriplets(entries.begin(), entries.end());
  return R;
}

double smooth_energy(const Surface& surface, double c0)
{
  const BasisTable& table = surface.space->curvature_table();
  const SurfacePoints points = evaluate(table, surface.control);
  const Eigen::VectorXd mean = mean_curvature(table, points, surface.control);
  return points.area_weight.dot((2 * mean.array() - c0).square().matrix()) / 2;
}

}

double SmoothBending::energy(const Surface& surface) const
{
  return smooth_energy(surface, c0_);
}

TermForce SmoothBending::force(const Surface& surface) const
{
  const BasisTable& table = surface.space->curvature_table();
  const SurfacePoints points = evaluate(table, surface.control);
  const PointCurvature curvature = point_curvature(table, points, surface.control);
  Linearisation linear{ mass_matrix(surface.space->table(), surface.points),
    along_normals(bending_hessian(table, points, curvature), surface.normals) };
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> mass{ Eigen::SparseMatrix<double>(
    linear.mass) };
  const Eigen::VectorXd phi = mass.solve(bending_moments(table, points, curvature, c0_));
  return { { phi, {} }, std::move(linear) };
}

double CotanBending::energy(const Surface& surface) const
{
  return bending_energy(
    *surface.cotan, cotan_curvature(*surface.cotan, surface.vertices, normals()), c0_);
}

TermForce CotanBending::force(const Surface& surface) const
{
  const Curvature curvature = cotan_curvature(*surface.cotan, surface.vertices, normals());
  return { { bending_density(curvature, c0_), {} },
    Linearisation{
      {}, linearised(bending_matrix(*surface.cotan, curvature, c0_), curvature.normal) } };
}

SparseMatrix CotanBending::linearised(SparseMatrix response, const Points& normal) const
{
  return normal_part(response, normal);
}

double FittedBending::energy(const Surface& surface) const
{
  return surface.space->smooth()
    ? smooth_energy(surface, c0_)
    : bending_energy(*surface.cotan,
        cotan_curvature(*surface.cotan, surface.vertices, NormalScheme::area_weighted), c0_);
}

TermForce FittedBending::force(const Surface& surface) const
{
  return { { surface.collocation().fit(bending_density(vertex_curvature(surface), c0_)), {} }, {} };
}

double bending_energy(const SurfacePoints& surface, const PointCurvature& c, double c0)
{
  return surface.area_weight.dot((2 * c.mean.array() - c0).square().matrix()) / 2;
}

double bending_energy(const CotanGeometry& geometry, const Curvature& c, double c0)
{
  return geometry.vertex_area.dot((2 * c.mean.array() - c0).square().matrix()) / 2;
}

Eigen::VectorXd bending_density(const Curvature& c, double c0)
{
  const auto H = c.mean.array();
  return 2 * c.laplacian_mean.array() +
    (2 * H - c0) * (2 * H.square() - 2 * c.gauss.array() + c0 * H);
}

SparseMatrix bending_hessian(
  const BasisTable& table, const SurfacePoints& surface, const PointCurvature& c)
{
  return gram_matrix(table, surface,
    [&](int q, int k)
    { return c.laplacian[k] + (4 * c.mean[q] * c.mean[q] - 2 * c.gauss[q]) * table.value[k]; });
}

SparseMatrix bending_matrix(const CotanGeometry& geometry, const Curvature& c, double c0)
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
  const Eigen::VectorXd local = 4 * (c.mean.array().square() - c.gauss.array()) - c0 * c0;
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
