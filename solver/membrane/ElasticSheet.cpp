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
  return { nodal_gradient(*table_, fields_of(table_->du, table_->dv),
             [&](int row)
             {
               const State at = state(s, row);
               Eigen::Matrix<double, 3, 2> tangents, stress;
               tangents << s.tangent_u.row(row).transpose(), s.tangent_v.row(row).transpose();
               stress << tangents * Eigen::Vector2d(at.uu, at.uv),
                 tangents * Eigen::Vector2d(at.uv, at.vv);
               return Eigen::Matrix<double, 3, 2>(weight_[row] * stress);
             }),
    {} };
}

}
