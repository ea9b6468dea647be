#include "solver/membrane/ElasticSheet.h"

#include "solver/ParallelFor.h"
#include "solver/surface/NodalSum.h"
#include "solver/surface/TangentFrame.h"

#include <algorithm>
#include <cmath>

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

/// ½ (∂/∂ε)² of the part of W that depends on the area alone, which grows by 1 + ε.
double dilation_stiffness(const ElasticModuli& m, double squared_area)
{
  return m.law == ElasticLaw::neo_hookean ? m.shear / squared_area
                                          : m.shear * m.dilation * squared_area * squared_area;
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
  const double shear = std::max(W.by_i1, 0.) * (i1 + 2);
  return { W.energy, 2 * (W.by_i1 * A[0] + i2 * a.vv), 2 * (W.by_i1 * A[1] - i2 * a.uv),
    2 * (W.by_i1 * A[2] + i2 * a.uu), shear, shear + 2 * dilation_stiffness(moduli_, ratio) };
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
    rates(s) };
}

// In an orthonormal frame t, s of the tangent plane a strain e has (shear/2) [(e_tt − e_ss)² + (2 e_ts)²] +
// (dilation/2) (e_tt + e_ss)² an area.
std::vector<EntryVectors> ElasticSheet::rates(const SurfacePoints& surface) const
{
  const auto entries = static_cast<Eigen::Index>(table_->node.size());
  std::vector<EntryVectors> rates(3, EntryVectors(entries, 3));
  const auto at_row = [&](int row)
  {
    const State at = state(surface, row);
    const double shear = std::sqrt(weight_[row] * at.shear / 2),
                 dilation = std::sqrt(weight_[row] * at.dilation / 2);
    const TangentFrame frame(surface, row);
    for (int k = table_->start[row]; k < table_->start[row + 1]; ++k)
    {
      const auto strain = frame.strain(table_->du[k], table_->dv[k]);
      rates[0].row(k) = shear * strain.elongation;
      rates[1].row(k) = shear * strain.shear;
      rates[2].row(k) = dilation * strain.dilation;
    }
  };
  parallel_for(table_->rows(), at_row, 256);
  return rates;
}

}
