#include "solver/surface/SurfaceIntegrals.h"

#include "solver/ParallelFor.h"
#include "solver/surface/ElementPattern.h"
#include "solver/surface/NodalSum.h"

#include <algorithm>
#include <array>

namespace vesicle
{

namespace
{

using Row3 = Eigen::RowVector3d;

// Rows of a task: some ten thousand operations.
constexpr int task_rows = 256;

// Calls visit(row) for every row, in parallel.
template<class Visit>
void for_each_row(int rows, Visit visit)
{
  parallel_for(rows, visit, task_rows);
}

// Calls visit(begin, end) for parts of the rows, in parallel.
template<class Visit>
void for_each_part(int rows, Visit visit)
{
  parallel_for((rows + task_rows - 1) / task_rows,
    [&](int task) { visit(task * task_rows, std::min((task + 1) * task_rows, rows)); });
}

// The area's centroid: volumes are computed from there, so that a vesicle far from the origin loses
// no digits, and, where the quadrature leaves a trace of ∮ n dS, the numbering has no say.
Row3 reference_point(const SurfacePoints& s)
{
  return s.area_weight.transpose() * s.position / s.area_weight.sum();
}

// Of a row's share of the area, with respect to its tangents: weight · |a_u × a_v| ∇_s N_k is
// weight · [∂N_k/∂u (a_v × n) + ∂N_k/∂v (n × a_u)].
Eigen::Matrix<double, 3, 2> share_of_area(const BasisTable& table, const SurfacePoints& s, int q)
{
  const Row3 n = s.cross.row(q).normalized();
  Eigen::Matrix<double, 3, 2> gradient;
  gradient << (table.weight[q] * s.tangent_v.row(q).cross(n)).transpose(),
    (table.weight[q] * n.cross(s.tangent_u.row(q))).transpose();
  return gradient;
}

}

SurfacePoints evaluate(const BasisTable& table, const Points& nodes)
{
  const int rows = table.rows();
  const PaddedPoints x = padded(nodes);
  SurfacePoints s{ RowVectors(rows, 3), RowVectors(rows, 3), RowVectors(rows, 3),
    RowVectors(rows, 3), Eigen::VectorXd(rows) };
  const auto fields = fields_of(table.value, table.du, table.dv);
  const std::array sums{ s.position.data(), s.tangent_u.data(), s.tangent_v.data() };
  for_each_part(rows,
    [&](int begin, int end)
    {
      sum_over_entries({ table, fields, begin, end }, x, sums, rows);
      for (int q = begin; q < end; ++q)
      {
        s.cross.row(q) = s.tangent_u.row(q).cross(s.tangent_v.row(q));
        s.area_weight[q] = table.weight[q] * s.cross.row(q).norm();
      }
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
  const PaddedPoints x = padded(nodal);
  RowVectors values(table.rows(), 3);
  const auto fields = fields_of(table.value);
  const std::array sums{ values.data() };
  for_each_part(table.rows(),
    [&](int begin, int end) {
      sum_over_entries({ table, fields, begin, end }, x, sums, table.rows());
    });
  return values;
}

SecondDerivatives second_derivatives(const BasisTable& table, const Points& nodes)
{
  const int rows = table.rows();
  const PaddedPoints x = padded(nodes);
  SecondDerivatives d{ RowVectors(rows, 3), RowVectors(rows, 3), RowVectors(rows, 3) };
  const auto fields = fields_of(table.duu, table.duv, table.dvv);
  const std::array sums{ d.uu.data(), d.uv.data(), d.vv.data() };
  for_each_part(rows,
    [&](int begin, int end) {
      sum_over_entries({ table, fields, begin, end }, x, sums, rows);
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
  const EntryVectors gradients = entry_gradients(
    table, fields_of(table.du, table.dv), [&](int q) { return share_of_area(table, s, q); });
  return element_sum<1, 3>(table,
    [&](ElementSum<1, 3>& sum, int, int first, int)
    { sum.add_outer_product(1, table.value.data() + first, gradients.row(first).data()); });
}

// The functions N_k add up to 1.
Eigen::VectorXd area_gradient(const BasisTable& table, const SurfacePoints& s)
{
  return nodal_gradient(
    table, fields_of(table.du, table.dv), [&](int q) { return share_of_area(table, s, q); });
}

Eigen::VectorXd volume_gradient(const BasisTable& table, const SurfacePoints& s)
{
  // V is cubic in the nodes; its exact derivative keeps the tangential parts that cancel only when
  // the quadrature is exact.
  const Row3 origin = reference_point(s);
  return nodal_gradient(table, fields_of(table.value, table.du, table.dv),
    [&](int q)
    {
      const Row3 x = s.position.row(q) - origin;
      Eigen::Matrix3d gradient;
      gradient << s.cross.row(q).transpose(), s.tangent_v.row(q).cross(x).transpose(),
        x.cross(s.tangent_u.row(q)).transpose();
      return Eigen::Matrix3d(table.weight[q] / 3 * gradient);
    });
}

Eigen::VectorXd normal_load(
  const BasisTable& table, const SurfacePoints& s, const Eigen::VectorXd& density)
{
  return nodal_gradient(table, fields_of(table.value),
    [&](int q) -> Vector3 { return table.weight[q] * density[q] * s.cross.row(q).transpose(); });
}

Eigen::Matrix<double, 3, Eigen::Dynamic> centroid_velocity_matrix(
  const BasisTable& table, const SurfacePoints& s)
{
  const Vector3 center = centroid(table, s);
  Eigen::Matrix<double, 3, Eigen::Dynamic> W(3, 3 * table.nodes);
  for (int d = 0; d < 3; ++d)
    W.row(d) =
      normal_load(table, s, s.position.col(d).array() - center[d]).transpose() / volume(table, s);
  return W;
}

Points area_weighted_normals(const Eigen::VectorXd& volume_gradient)
{
  Points normals = volume_gradient.reshaped<Eigen::RowMajor>(volume_gradient.size() / 3, 3);
  normals.rowwise().normalize();
  return normals;
}

}
