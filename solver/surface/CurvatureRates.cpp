#include "solver/surface/CurvatureRates.h"

#include "solver/ParallelFor.h"
#include "solver/surface/NodalSum.h"

namespace vesicle
{

namespace
{

using Row3 = Eigen::RowVector3d;

/// What the rates of a row's entries are made of.
struct RowFrame
{
  double g_uu, g_uv, g_vv; // a^{αβ}
  double trace_u, trace_v; // a^{αβ} Γ^γ_{αβ}
  Row3 normal;
  Row3 along_u, along_v; // the vectors that ∂_u δx and ∂_v δx are multiplied by, of 2H
  Row3 dual_u, dual_v;   // a^u, a^v
  double twice_mean;

  RowFrame(const SurfacePoints& s, const SecondDerivatives& second, int q)
  {
    const Row3 uu = second.uu.row(q), uv = second.uv.row(q), vv = second.vv.row(q);
    const Row3 a = s.tangent_u.row(q), b = s.tangent_v.row(q), cross = s.cross.row(q);
    const double J = cross.norm();
    g_uu = b.squaredNorm() / (J * J);
    g_uv = -a.dot(b) / (J * J);
    g_vv = a.squaredNorm() / (J * J);
    normal = cross / J;
    dual_u = b.cross(normal) / J;
    dual_v = normal.cross(a) / J;
    const Row3 trace = g_uu * uu + 2 * g_uv * uv + g_vv * vv;
    trace_u = trace.dot(dual_u);
    trace_v = trace.dot(dual_v);
    twice_mean = -trace.dot(normal);
    // b^{αβ} a_α = a^{βμ} b_{μν} a^ν, b_{μν} = ∂_μ∂_ν x·n
    const Row3 lowered_u = uu.dot(normal) * dual_u + uv.dot(normal) * dual_v,
               lowered_v = uv.dot(normal) * dual_u + vv.dot(normal) * dual_v;
    along_u = 2 * (g_uu * lowered_u + g_uv * lowered_v);
    along_v = 2 * (g_uv * lowered_u + g_vv * lowered_v);
  }

  double laplacian(const BasisTable& t, int k) const
  {
    return g_uu * t.duu[k] + 2 * g_uv * t.duv[k] + g_vv * t.dvv[k] - trace_u * t.du[k] -
      trace_v * t.dv[k];
  }
};

}

CurvatureRates curvature_rates(
  const BasisTable& table, const SurfacePoints& surface, const Points& control)
{
  const SecondDerivatives second = second_derivatives(table, control);
  const auto entries = static_cast<Eigen::Index>(table.node.size());
  CurvatureRates rates{ Eigen::VectorXd(table.rows()), EntryVectors(entries, 3),
    EntryVectors(entries, 3) };
  parallel_for(
    table.rows(),
    [&](int q)
    {
      const RowFrame frame(surface, second, q);
      rates.twice_mean[q] = frame.twice_mean;
      for (int k = table.start[q]; k < table.start[q + 1]; ++k)
      {
        rates.of_twice_mean.row(k) = -frame.laplacian(table, k) * frame.normal +
          table.du[k] * frame.along_u + table.dv[k] * frame.along_v;
        rates.of_area.row(k) = table.du[k] * frame.dual_u + table.dv[k] * frame.dual_v;
      }
    },
    256);
  return rates;
}

Eigen::VectorXd integrated_mean_curvature_gradient(
  const BasisTable& table, const SurfacePoints& surface, const Points& control)
{
  const CurvatureRates rates = curvature_rates(table, surface, control);
  const Points gradient = nodal_sum<3>(table,
    [&](Points& sum, int q)
    {
      for (int k = table.start[q]; k < table.start[q + 1]; ++k)
        sum.row(table.node[k]) += surface.area_weight[q] / 2 *
          (rates.of_twice_mean.row(k) + rates.twice_mean[q] * rates.of_area.row(k));
    });
  return gradient.reshaped<Eigen::RowMajor>();
}

}
