#include "solver/membrane/HelfrichBending.h"

#include "solver/membrane/BendingVariation.h"
#include "solver/membrane/PaperScheme.h"
#include "solver/surface/FittedCurvature.h"

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

double smooth_energy(const Surface& surface, double c0)
{
  return surface.points.area_weight.dot(
           (2 * surface.curvature->mean.array() - c0).square().matrix()) /
    2;
}

}

double SmoothBending::energy(const Surface& surface) const
{
  return smooth_energy(surface, c0_);
}

Variation SmoothBending::variation(const Surface& surface) const
{
  return bending_variation(surface.space->table(), surface.points, surface.control, c0_);
}

void SmoothBending::add_curvature_energy(const CurvedPoints& surface, CurvatureEnergy& sum) const
{
  const Eigen::ArrayXd excess = surface.twice_mean.array() - c0_;
  const Eigen::VectorXd value = excess.square() / 2;
  sum.energy += surface.points.area_weight.dot(value);
  sum.density.value += value;
  sum.density.slope.array() += excess;
  sum.density.curvature.array() += 1;
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
    linearised(bending_matrix(*surface.cotan, curvature, c0_), curvature.normal) };
}

SparseMatrix CotanBending::linearised(const SparseMatrix& response, const Points& normal) const
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
  return { { bending_density(vertex_curvature(surface), c0_), {} }, {} };
}

Variation FittedBending::variation(const Surface& surface) const
{
  const BasisTable& table = surface.space->table();
  const Eigen::VectorXd nodal =
    surface.collocation().fit(bending_density(vertex_curvature(surface), c0_));
  return { -normal_load(table, surface.points, interpolate(table, nodal)), {} };
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
