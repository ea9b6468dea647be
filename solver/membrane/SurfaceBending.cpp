#include "solver/membrane/SurfaceBending.h"

#include <vector>

namespace vesicle
{

namespace
{

using Row3 = Eigen::RowVector3d;

// Σ_rows dS a_j a_k for entry values a.
template<class Value>
SparseMatrix gram_matrix(const BasisTable& table, const SurfacePoints& surface, Value value)
{
  std::vector<Eigen::Triplet<double>> entries;
  for_each_element(table,
    [&](int begin, int end, std::span<const int> nodes)
    {
      const auto width = static_cast<Eigen::Index>(nodes.size());
      Eigen::MatrixXd local = Eigen::MatrixXd::Zero(width, width);
      Eigen::VectorXd a(width);
      for (int q = begin; q < end; ++q)
      {
        for (Eigen::Index k = 0; k < width; ++k)
          a[k] = value(q, table.start[q] + static_cast<int>(k));
        local.noalias() += surface.area_weight[q] * a * a.transpose();
      }
      for (Eigen::Index j = 0; j < width; ++j)
        for (Eigen::Index k = 0; k < width; ++k)
          entries.emplace_back(nodes[j], nodes[k], local(j, k));
    });
  SparseMatrix gram(table.nodes, table.nodes);
  gram.setFromTriplets(entries.begin(), entries.end());
  return gram;
}

}

RowCurvature row_curvature(const BasisTable& table, const SurfacePoints& s, const Points& control)
{
  RowCurvature c{ Eigen::VectorXd(table.rows()), Eigen::VectorXd(table.rows()),
    std::vector<double>(table.node.size()) };
  const SecondDerivatives second = second_derivatives(table, control);
  for (int q = 0; q < table.rows(); ++q)
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
    const double along_u = trace.dot(dual_u), along_v = trace.dot(dual_v);
    for (int k = table.start[q]; k < table.start[q + 1]; ++k)
      c.laplacian[k] = g_uu * table.duu[k] + 2 * g_uv * table.duv[k] + g_vv * table.dvv[k] -
        along_u * table.du[k] - along_v * table.dv[k];
  }
  return c;
}

double bending_energy(const SurfacePoints& surface, const RowCurvature& c)
{
  return 2 * surface.area_weight.dot(c.mean.cwiseAbs2());
}

Eigen::VectorXd bending_load(
  const BasisTable& table, const SurfacePoints& surface, const RowCurvature& c)
{
  Eigen::VectorXd load = Eigen::VectorXd::Zero(table.nodes);
  for (int q = 0; q < table.rows(); ++q)
  {
    const double H = c.mean[q], local = 4 * H * (H * H - c.gauss[q]);
    for (int k = table.start[q]; k < table.start[q + 1]; ++k)
      load[table.node[k]] +=
        surface.area_weight[q] * (2 * H * c.laplacian[k] + local * table.value[k]);
  }
  return load;
}

SparseMatrix bending_hessian(
  const BasisTable& table, const SurfacePoints& surface, const RowCurvature& c)
{
  return gram_matrix(table, surface,
    [&](int q, int k)
    { return c.laplacian[k] + (4 * c.mean[q] * c.mean[q] - 2 * c.gauss[q]) * table.value[k]; });
}

SparseMatrix bilaplacian(
  const BasisTable& table, const SurfacePoints& surface, const RowCurvature& c)
{
  return gram_matrix(table, surface, [&](int, int k) { return c.laplacian[k]; });
}

SparseMatrix mass_matrix(const BasisTable& table, const SurfacePoints& surface)
{
  return gram_matrix(table, surface, [&](int, int k) { return table.value[k]; });
}

Eigen::VectorXd moments(
  const BasisTable& table, const SurfacePoints& surface, const Eigen::VectorXd& f)
{
  Eigen::VectorXd result = Eigen::VectorXd::Zero(table.nodes);
  for (int q = 0; q < table.rows(); ++q)
    for (int k = table.start[q]; k < table.start[q + 1]; ++k)
      result[table.node[k]] += surface.area_weight[q] * f[q] * table.value[k];
  return result;
}

}
