#include "solver/surface/SurfaceIntegrals.h"

#include "solver/ParallelFor.h"
#include "solver/surface/ElementPattern.h"
#include "solver/surface/NodalSum.h"

#include <vector>

namespace vesicle
{

namespace
{

using Row3 = Eigen::RowVector3d;

// Calls visit(row) for every row, in parallel.
template<class Visit>
void for_each_row(int rows, Visit visit)
{
  constexpr int grain = 256; // rows, some ten thousand operations
  parallel_for(rows, visit, grain);
}

// The area's centroid: volumes are computed from there, so that a vesicle far from the origin loses
// no digits, and, where the quadrature leaves a trace of ∮ n dS, the numbering has no say.
Row3 reference_point(const SurfacePoints& s)
{
  return s.area_weight.transpose() * s.position / s.area_weight.sum();
}

// weight · |a_u × a_v| ∇_s N_k = weight · [∂N_k/∂u (a_v × n) + ∂N_k/∂v (n × a_u)]: the derivative
// of the row's share of the area with respect to node k.
struct ScaledGradient
{
  Row3 along_u, along_v;
  ScaledGradient(const BasisTable& table, const SurfacePoints& s, int q)
  {
    const Row3 n = s.cross.row(q).normalized();
    along_u = table.weight[q] * s.tangent_v.row(q).cross(n);
    along_v = table.weight[q] * n.cross(s.tangent_u.row(q));
  }
  Row3 of(const BasisTable& table, int k) const
  {
    return table.du[k] * along_u + table.dv[k] * along_v;
  }
};

}

SurfacePoints evaluate(const BasisTable& table, const Points& nodes)
{
  const int rows = table.rows();
  SurfacePoints s{ RowVectors(rows, 3), RowVectors(rows, 3), RowVectors(rows, 3),
    RowVectors(rows, 3), Eigen::VectorXd(rows) };
  for_each_row(table.rows(),
    [&](int q)
    {
      Row3 x = Row3::Zero(), a = x, b = x;
      for (int k = table.start[q]; k < table.start[q + 1]; ++k)
      {
        const auto node = nodes.row(table.node[k]);
        x += table.value[k] * node;
        a += table.du[k] * node;
        b += table.dv[k] * node;
      }
      s.position.row(q) = x;
      s.tangent_u.row(q) = a;
      s.tangent_v.row(q) = b;
      s.cross.row(q) = a.cross(b);
      s.area_weight[q] = table.weight[q] * s.cross.row(q).norm();
    });
  return s;
}

Eigen::VectorXd interpolate(const BasisTable& table, const Eigen::VectorXd& nodal)
{
  Eigen::VectorXd values(table.rows());
  for_each_row(table.rows(),
    [&](int q)
    {
      double value = 0;
      for (int k = table.start[q]; k < table.start[q + 1]; ++k)
        value += table.value[k] * nodal[table.node[k]];
      values[q] = value;
    });
  return values;
}

Eigen::RowVector3d interpolate(const BasisTable& table, int row, const Points& nodal)
{
  Eigen::RowVector3d value = Eigen::RowVector3d::Zero();
  for (int k = table.start[row]; k < table.start[row + 1]; ++k)
    value += table.value[k] * nodal.row(table.node[k]);
  return value;
}

RowVectors interpolate(const BasisTable& table, const Points& nodal)
{
  RowVectors values(table.rows(), 3);
  for_each_row(table.rows(), [&](int row) { values.row(row) = interpolate(table, row, nodal); });
  return values;
}

SecondDerivatives second_derivatives(const BasisTable& table, const Points& nodes)
{
  const int rows = table.rows();
  SecondDerivatives d{ RowVectors(rows, 3), RowVectors(rows, 3), RowVectors(rows, 3) };
  for_each_row(table.rows(),
    [&](int q)
    {
      Row3 uu = Row3::Zero(), uv = uu, vv = uu;
      for (int k = table.start[q]; k < table.start[q + 1]; ++k)
      {
        const auto node = nodes.row(table.node[k]);
        uu += table.duu[k] * node;
        uv += table.duv[k] * node;
        vv += table.dvv[k] * node;
      }
      d.uu.row(q) = uu;
      d.uv.row(q) = uv;
      d.vv.row(q) = vv;
    });
  return d;
}

Eigen::VectorXd mean_curvature(const BasisTable& table, const SurfacePoints& s, const Points& nodes)
{
  return mean_curvature(s, second_derivatives(table, nodes));
}

Eigen::VectorXd mean_curvature(const SurfacePoints& s, const SecondDerivatives& d)
{
  Eigen::VectorXd mean(s.cross.rows());
  for_each_row(static_cast<int>(mean.size()),
    [&](int q)
    {
      const Row3 a = s.tangent_u.row(q), b = s.tangent_v.row(q), c = s.cross.row(q);
      const double J = c.norm();
      mean[q] = -0.5 *
        (b.squaredNorm() * d.uu.row(q).dot(c) - 2 * a.dot(b) * d.uv.row(q).dot(c) +
          a.squaredNorm() * d.vv.row(q).dot(c)) /
        (J * J * J);
    });
  return mean;
}

double area(const SurfacePoints& surface)
{
  return surface.area_weight.sum();
}

double volume(const BasisTable& table, const SurfacePoints& s)
{
  const Row3 origin = reference_point(s);
  double sum = 0;
  for (int q = 0; q < table.rows(); ++q)
    sum += table.weight[q] * (s.position.row(q) - origin).dot(s.cross.row(q));
  return sum / 3;
}

Vector3 centroid(const BasisTable& table, const SurfacePoints& s)
{
  const Row3 origin = reference_point(s);
  Row3 moment = Row3::Zero();
  for (int q = 0; q < table.rows(); ++q)
    moment += table.weight[q] * (s.position.row(q) - origin).squaredNorm() * s.cross.row(q);
  return (origin + moment / (2 * volume(table, s))).transpose();
}

Eigen::VectorXd vertex_areas(const BasisTable& table, const SurfacePoints& s)
{
  return nodal_sum<1>(table,
    [&](Eigen::VectorXd& areas, int q)
    {
      for (int k = table.start[q]; k < table.start[q + 1]; ++k)
        areas[table.node[k]] += s.area_weight[q] * table.value[k];
    });
}

SparseMatrix area_rate_matrix(const BasisTable& table, const SurfacePoints& s)
{
  return element_sum(table, 1, 3,
    [&](ElementSum& sum, int q, int first, int width)
    {
      const ScaledGradient gradient(table, s, q);
      thread_local Points gradients;
      gradients.resize(width, 3);
      for (int j = 0; j < width; ++j)
        gradients.row(j) = gradient.of(table, first + j);
      sum.add_outer_product(1, table.value.data() + first, gradients.data());
    });
}

// The functions N_k add up to 1.
Eigen::VectorXd area_gradient(const BasisTable& table, const SurfacePoints& s)
{
  const Points total = nodal_sum<3>(table,
    [&](Points& sum, int q)
    {
      const ScaledGradient gradient(table, s, q);
      for (int k = table.start[q]; k < table.start[q + 1]; ++k)
        sum.row(table.node[k]) += gradient.of(table, k);
    });
  return total.reshaped<Eigen::RowMajor>();
}

Eigen::VectorXd volume_gradient(const BasisTable& table, const SurfacePoints& s)
{
  // V is cubic in the nodes; its exact derivative keeps the tangential parts that cancel only when
  // the quadrature is exact.
  const Row3 origin = reference_point(s);
  const Points gradient = nodal_sum<3>(table,
    [&](Points& sum, int q)
    {
      const Row3 x = s.position.row(q) - origin, along_u = s.tangent_v.row(q).cross(x),
                 along_v = x.cross(s.tangent_u.row(q)), n = s.cross.row(q);
      for (int k = table.start[q]; k < table.start[q + 1]; ++k)
        sum.row(table.node[k]) += table.weight[q] / 3 *
          (table.value[k] * n + table.du[k] * along_u + table.dv[k] * along_v);
    });
  return gradient.reshaped<Eigen::RowMajor>();
}

Eigen::VectorXd normal_load(
  const BasisTable& table, const SurfacePoints& s, const Eigen::VectorXd& density)
{
  const Points load = nodal_sum<3>(table,
    [&](Points& sum, int q)
    {
      const Row3 f = table.weight[q] * density[q] * s.cross.row(q);
      for (int k = table.start[q]; k < table.start[q + 1]; ++k)
        sum.row(table.node[k]) += table.value[k] * f;
    });
  return load.reshaped<Eigen::RowMajor>();
}

Eigen::Matrix<double, 3, Eigen::Dynamic> centroid_velocity_matrix(
  const BasisTable& table, const SurfacePoints& s)
{
  const Row3 center = centroid(table, s).transpose();
  Eigen::Matrix<double, 3, Eigen::Dynamic> W =
    Eigen::Matrix<double, 3, Eigen::Dynamic>::Zero(3, 3 * table.nodes);
  for (int q = 0; q < table.rows(); ++q)
    for (int k = table.start[q]; k < table.start[q + 1]; ++k)
      W.block<3, 3>(0, 3 * table.node[k]) += table.weight[q] * table.value[k] *
        (s.position.row(q) - center).transpose() * s.cross.row(q);
  return W / volume(table, s);
}

Points area_weighted_normals(const Eigen::VectorXd& volume_gradient)
{
  Points normals = volume_gradient.reshaped<Eigen::RowMajor>(volume_gradient.size() / 3, 3);
  normals.rowwise().normalize();
  return normals;
}

}
