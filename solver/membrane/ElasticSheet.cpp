#include "solver/membrane/ElasticSheet.h"

#include "solver/surface/NodalSum.h"

namespace vesicle
{

namespace
{

struct Metric
{
  double uu, uv, vv;
  Metric(const SurfacePoints& s, int row)
    : uu(s.tangent_u.row(row).squaredNorm()), uv(s.tangent_u.row(row).dot(s.tangent_v.row(row))),
      vv(s.tangent_v.row(row).squaredNorm())
  {
  }
  double determinant() const { return uu * vv - uv * uv; }
};

/// W and its derivatives.
struct StrainEnergy
{
  double energy, by_i1, by_i2;
};

StrainEnergy strain_energy(const ElasticModuli& m, double i1, double i2)
{
  const double G = m.shear, C = m.dilation;
  if (m.law == ElasticLaw::neo_hookean)
    return { G / 2 * (i1 - 1 + 1 / (i2 + 1)), G / 2, -G / 2 / ((i2 + 1) * (i2 + 1)) };
  return { G / 4 * (i1 * i1 + 2 * i1 - 2 * i2 + C * i2 * i2), G / 2 * (i1 + 1),
    G / 2 * (C * i2 - 1) };
}

}

ElasticSheet::ElasticSheet(
  const ElasticModuli& moduli, const SurfaceSpace& space, const Points& reference)
  : moduli_(moduli), table_(&space.table())
{
  const SurfacePoints s =
    evaluate(*table_, rows_of_three(space.collocation().to_control(flat(reference))));
  weight_ = s.area_weight;
  inverse_metric_.resize(table_->rows(), 3);
  inverse_determinant_.resize(table_->rows());
  for (int row = 0; row < table_->rows(); ++row)
  {
    const Metric A(s, row);
    inverse_determinant_[row] = 1 / A.determinant();
    inverse_metric_.row(row) = Eigen::RowVector3d(A.vv, -A.uv, A.uu) * inverse_determinant_[row];
  }
}

ElasticSheet::State ElasticSheet::state(const SurfacePoints& surface, int row) const
{
  const Metric a(surface, row);
  const auto A = inverse_metric_.row(row);
  const double ratio = a.determinant() * inverse_determinant_[row],
               i1 = A[0] * a.uu + 2 * A[1] * a.uv + A[2] * a.vv - 2;
  const StrainEnergy W = strain_energy(moduli_, i1, ratio - 1);
  // ∂I2/∂a_αβ = det a/det A a^{αβ}: the adjugate of a over det A.
  const double i2 = W.by_i2 * inverse_determinant_[row];
  return { W.energy, 2 * (W.by_i1 * A[0] + i2 * a.vv), 2 * (W.by_i1 * A[1] - i2 * a.uv),
    2 * (W.by_i1 * A[2] + i2 * a.uu) };
}

double ElasticSheet::energy(const Surface& surface) const
{
  double sum = 0;
  for (int row = 0; row < table_->rows(); ++row)
    sum += weight_[row] * state(surface.points, row).energy;
  return sum;
}

Variation ElasticSheet::variation(const Surface& surface) const
{
  const SurfacePoints& s = surface.points;
  const Points gradient = nodal_sum<3>(*table_,
    [&](Points& sum, int row)
    {
      const State at = state(s, row);
      const Eigen::RowVector3d x_u = s.tangent_u.row(row), x_v = s.tangent_v.row(row),
                               by_u = weight_[row] * (at.uu * x_u + at.uv * x_v),
                               by_v = weight_[row] * (at.uv * x_u + at.vv * x_v);
      for (int k = table_->start[row]; k < table_->start[row + 1]; ++k)
        sum.row(table_->node[k]) += table_->du[k] * by_u + table_->dv[k] * by_v;
    });
  return { gradient.reshaped<Eigen::RowMajor>(), {} };
}

}
