#include "solver/surface/CurvatureRates.h"

#include "solver/ParallelFor.h"
#include "solver/surface/NodalSum.h"

namespace vesicle
{

namespace
{

void set_row(CurvatureRates& rates, const SurfacePoints& s, const SecondDerivatives& second, int q)
{
  const Vector3 uu = second.uu.row(q), uv = second.uv.row(q), vv = second.vv.row(q);
  const Vector3 a = s.tangent_u.row(q), b = s.tangent_v.row(q), cross = s.cross.row(q);
  const double J = cross.norm(), g_uu = b.squaredNorm() / (J * J), g_uv = -a.dot(b) / (J * J),
               g_vv = a.squaredNorm() / (J * J); // a^{αβ}
  const Vector3 normal = cross / J, dual_u = b.cross(normal) / J, dual_v = normal.cross(a) / J;
  const Vector3 trace = g_uu * uu + 2 * g_uv * uv + g_vv * vv; // its parts: a^{αβ} Γ^γ_{αβ}, −2H
  // b^{αβ} a_α = a^{βμ} b_{μν} a^ν, b_{μν} = ∂_μ∂_ν x·n
  const Vector3 lowered_u = uu.dot(normal) * dual_u + uv.dot(normal) * dual_v,
                lowered_v = uv.dot(normal) * dual_u + vv.dot(normal) * dual_v;
  rates.twice_mean[q] = -trace.dot(normal);
  rates.of_twice_mean[q] << trace.dot(dual_u) * normal + 2 * (g_uu * lowered_u + g_uv * lowered_v),
    trace.dot(dual_v) * normal + 2 * (g_uv * lowered_u + g_vv * lowered_v), -g_uu * normal,
    -2 * g_uv * normal, -g_vv * normal;
  rates.of_area[q] << dual_u, dual_v;
}

}

CurvatureRates curvature_rates(
  const BasisTable& table, const SurfacePoints& surface, const Points& control)
{
  const SecondDerivatives second = second_derivatives(table, control);
  const std::size_t rows = table.rows();
  CurvatureRates rates{ Eigen::VectorXd(table.rows()), std::vector<CurvatureRates::Gradient>(rows),
    std::vector<Eigen::Matrix<double, 3, 2>>(rows) };
  constexpr int grain = 256; // rows
  parallel_for(
    table.rows(), [&](int q) { set_row(rates, surface, second, q); }, grain);
  return rates;
}

std::array<const double*, 5> curvature_fields(const BasisTable& table)
{
  return fields_of(table.du, table.dv, table.duu, table.duv, table.dvv);
}

Eigen::VectorXd integrated_mean_curvature_gradient(
  const BasisTable& table, const SurfacePoints& surface, const Points& control)
{
  const CurvatureRates rates = curvature_rates(table, surface, control);
  return nodal_gradient(table, curvature_fields(table),
    [&](int q)
    {
      CurvatureRates::Gradient gradient = rates.of_twice_mean[q];
      gradient.leftCols<2>() += rates.twice_mean[q] * rates.of_area[q];
      return CurvatureRates::Gradient(surface.area_weight[q] / 2 * gradient);
    });
}

}
