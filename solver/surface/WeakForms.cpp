#include "solver/surface/WeakForms.h"

#include "solver/ParallelFor.h"
#include "solver/surface/TableLoops.h"

namespace vesicle
{

namespace
{

using Row3 = Eigen::RowVector3d;

}

PointCurvature point_curvature(
  const BasisTable& table, const SurfacePoints& s, const Points& control)
{
  PointCurvature c{ Eigen::VectorXd(table.rows()), Eigen::VectorXd(table.rows()),
    std::vector<double>(table.node.size()) };
  const SecondDerivatives second = second_derivatives(table, control);
  const auto fields = fields_of(table.du, table.dv, table.duu, table.duv, table.dvv);
  const auto at_row = [&](int q)
  {
    const Row3 uu = second.uu.row(q), uv = second.uv.row(q), vv = second.vv.row(q);
    const Row3 a = s.tangent_u.row(q), b = s.tangent_v.row(q), cross = s.cross.row(q);
    const double J = cross.norm(), g_uu = b.squaredNorm() / (J * J), g_uv = -a.dot(b) / (J * J),
                 g_vv = a.squaredNorm() / (J * J);
    const Row3 n = cross / J, dual_u = b.cross(n) / J, dual_v = n.cross(a) / J;
    c.mean[q] = -0.5 * (g_uu * uu.dot(n) + 2 * g_uv * uv.dot(n) + g_vv * vv.dot(n));
    c.gauss[q] = (uu.dot(n) * vv.dot(n) - uv.dot(n) * uv.dot(n)) / (J * J);
    // a^{αβ} Γ^γ_{αβ}, Γ^γ_{αβ} = ∂_α∂_β x · a^γ.
    const Row3 trace = g_uu * uu + 2 * g_uv * uv + g_vv * vv;
    const std::array of_fields{ -trace.dot(dual_u), -trace.dot(dual_v), g_uu, 2 * g_uv, g_vv };
    combine_numbers({ table, fields, q, q + 1 }, of_fields.data(), c.laplacian.data());
  };
  parallel_for(table.rows(), at_row, 256);
  return c;
}

SparseMatrix gauss_newton_matrix(const BasisTable& table, const std::vector<EntryVectors>& rates)
{
  return element_sum<3, 3>(table,
    [&](ElementSum<3, 3>& sum, int, int first, int)
    {
      for (const EntryVectors& R : rates)
      {
        const double* row = R.data() + 3L * first;
        sum.add_outer_product(2, row, row);
      }
    });
}

SparseMatrix mass_matrix(const BasisTable& table, const SurfacePoints& surface)
{
  return gram_matrix(table, surface, [&](int, int k) { return table.value[k]; });
}

// ∇N_j·∇N_k by an orthonormal frame at each point: two numbers an entry.
SparseMatrix stiffness_matrix(const BasisTable& table, const SurfacePoints& s)
{
  return element_sum<1, 1>(table,
    [&](ElementSum<1, 1>& sum, int q, int first, int width)
    {
      const Row3 a = s.tangent_u.row(q), b = s.tangent_v.row(q);
      const double length = a.norm(), J = s.cross.row(q).norm(), skew = a.dot(b) / length;
      thread_local std::vector<double> along, across;
      along.resize(width);
      across.resize(width);
      for (int k = 0; k < width; ++k)
      {
        const double du = table.du[first + k], dv = table.dv[first + k];
        along[k] = du / length;
        across[k] = (dv * length - du * skew) / J;
      }
      sum.add_outer_product(s.area_weight[q], along.data(), along.data());
      sum.add_outer_product(s.area_weight[q], across.data(), across.data());
    });
}

SparseMatrix bilaplacian(
  const BasisTable& table, const SurfacePoints& surface, const PointCurvature& c)
{
  return gram_matrix(table, surface, [&](int, int k) { return c.laplacian[k]; });
}

void add_bending_moments(const BasisTable& table, const SurfacePoints& surface,
  const PointCurvature& c, double c0, Eigen::Ref<Eigen::VectorXd> to)
{
  for (int q = 0; q < table.rows(); ++q)
  {
    const double H = c.mean[q], excess = 2 * H - c0;
    const double local = excess * (2 * H * H - 2 * c.gauss[q] + c0 * H);
    for (int k = table.start[q]; k < table.start[q + 1]; ++k)
      to[table.node[k]] +=
        surface.area_weight[q] * (excess * c.laplacian[k] + local * table.value[k]);
  }
}

Eigen::VectorXd bending_moments(
  const BasisTable& table, const SurfacePoints& surface, const PointCurvature& c, double c0)
{
  Eigen::VectorXd load = Eigen::VectorXd::Zero(table.nodes);
  add_bending_moments(table, surface, c, c0, load);
  return load;
}

Eigen::VectorXd laplacian_of_mean(
  const Eigen::VectorXd& force, const Eigen::VectorXd& mean, const Eigen::VectorXd& gauss)
{
  const auto H = mean.array();
  return force.array() / 2 - 2 * H * (H * H - gauss.array());
}

void add_moments(const BasisTable& table, const SurfacePoints& surface, const Eigen::VectorXd& f,
  Eigen::Ref<Eigen::VectorXd> to)
{
  for (int q = 0; q < table.rows(); ++q)
    for (int k = table.start[q]; k < table.start[q + 1]; ++k)
      to[table.node[k]] += surface.area_weight[q] * f[q] * table.value[k];
}

Eigen::VectorXd moments(
  const BasisTable& table, const SurfacePoints& surface, const Eigen::VectorXd& f)
{
  Eigen::VectorXd result = Eigen::VectorXd::Zero(table.nodes);
  add_moments(table, surface, f, result);
  return result;
}

}
