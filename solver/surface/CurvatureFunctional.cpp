#include "solver/surface/CurvatureFunctional.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace vesicle
{

namespace
{

using Row3 = Eigen::RowVector3d;

// What a row's functional depends on: x, a, b, ∂²x/∂u², ∂²x/∂u∂v, ∂²x/∂v², three numbers each.
constexpr int fields = 6;
constexpr int along_a = 3, along_b = 6, along_second = 9;
using Gradient = Eigen::Matrix<double, 3 * fields, 1>;
using Hessian = Eigen::Matrix<double, 3 * fields, 3 * fields>;

std::array<double, fields> weights_of(const BasisTable& table, int k)
{
  return { table.value[k], table.du[k], table.dv[k], table.duu[k], table.duv[k], table.dvv[k] };
}

Eigen::Matrix3d cross_matrix(const Vector3& v)
{
  Eigen::Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

/// P and Q of a row with their derivatives.
struct RowPolynomials
{
  Vector3 a, b, m;
  std::array<Vector3, 3> second;
  std::array<double, 3> height, metric; // ∂²x·m; b², −2 a·b, a²
  double aa, ab, bb, Q;
  Gradient dP, dQ;
  Gradient d_aa = Gradient::Zero(), d_ab = Gradient::Zero(), d_bb = Gradient::Zero();
  std::array<Gradient, 3> d_height{ Gradient::Zero(), Gradient::Zero(), Gradient::Zero() };

  RowPolynomials(const CurvedPoints& s, int q)
    : a(s.points.tangent_u.row(q)), b(s.points.tangent_v.row(q)),
      m(s.points.cross.row(q)), second{ s.second.uu.row(q), s.second.uv.row(q),
        s.second.vv.row(q) },
      aa(a.squaredNorm()), ab(a.dot(b)), bb(b.squaredNorm()), Q(m.squaredNorm())
  {
    metric = { bb, -2 * ab, aa };
    d_aa.segment<3>(along_a) = 2 * a;
    d_bb.segment<3>(along_b) = 2 * b;
    d_ab.segment<3>(along_a) = b;
    d_ab.segment<3>(along_b) = a;
    for (int i = 0; i < 3; ++i)
    {
      height[i] = second[i].dot(m);
      d_height[i].segment<3>(along_a) = b.cross(second[i]);
      d_height[i].segment<3>(along_b) = second[i].cross(a);
      d_height[i].segment<3>(along_second + 3 * i) = m;
    }
    dP = height[0] * d_bb - 2 * height[1] * d_ab + height[2] * d_aa + metric[0] * d_height[0] +
      metric[1] * d_height[1] + metric[2] * d_height[2];
    dQ = aa * d_bb + bb * d_aa - 2 * ab * d_ab;
  }
};

/// w √Q φ(−P Q^{−3/2}) and its derivatives with respect to P and Q.
struct RowDensity
{
  double P, Q, PP, PQ, QQ;

  RowDensity(
    double weight, double squared, double twice_mean, double value, double slope, double curvature)
  {
    const double root = std::sqrt(squared), h = twice_mean;
    P = -weight * slope / squared;
    Q = weight * (value / 2 - 1.5 * h * slope) / root;
    PP = weight * curvature / (squared * squared * root);
    PQ = weight * (slope + 1.5 * h * curvature) / (squared * squared);
    QQ = weight * (-value / 4 + 2.25 * h * (slope + h * curvature)) / (squared * root);
  }
};

RowDensity row_density(
  const BasisTable& table, const CurvedPoints& s, const CurvatureDensity& d, int q, double squared)
{
  return { table.weight[q], squared, s.twice_mean[q], d.value[q], d.slope[q], d.curvature[q] };
}

void add_symmetric(Hessian& H, double factor, const Gradient& x, const Gradient& y)
{
  H.noalias() += (factor * x) * y.transpose();
  H.noalias() += (factor * y) * x.transpose();
}

void add_block(Hessian& H, int row, int column, const Eigen::Matrix3d& block)
{
  H.block<3, 3>(row, column) += block;
  H.block<3, 3>(column, row) += block.transpose();
}

/// F_P P″ + F_Q Q″.
void add_second_derivatives(Hessian& H, const RowPolynomials& r, const RowDensity& F)
{
  add_symmetric(H, F.P, r.d_bb, r.d_height[0]);
  add_symmetric(H, -2 * F.P, r.d_ab, r.d_height[1]);
  add_symmetric(H, F.P, r.d_aa, r.d_height[2]);
  add_symmetric(H, F.Q, r.d_aa, r.d_bb);
  H.noalias() -= (2 * F.Q * r.d_ab) * r.d_ab.transpose();
  H.diagonal().segment<3>(along_a).array() += 2 * (F.P * r.height[2] + F.Q * r.bb);
  H.diagonal().segment<3>(along_b).array() += 2 * (F.P * r.height[0] + F.Q * r.aa);
  add_block(
    H, along_a, along_b, -2 * (F.P * r.height[1] + F.Q * r.ab) * Eigen::Matrix3d::Identity());
  // ∂m/∂a = −[b]×, ∂m/∂b = [a]×, and m·y has ∂²/∂a∂b = −[y]×.
  const Eigen::Matrix3d of_a = -F.P * cross_matrix(r.b), of_b = F.P * cross_matrix(r.a);
  Vector3 sum = Vector3::Zero();
  for (int i = 0; i < 3; ++i)
  {
    add_block(H, along_second + 3 * i, along_a, r.metric[i] * of_a);
    add_block(H, along_second + 3 * i, along_b, r.metric[i] * of_b);
    sum += r.metric[i] * r.second[i];
  }
  add_block(H, along_a, along_b, -F.P * cross_matrix(sum));
}

/// Of factor · x·(a × b).
void add_volume(Hessian& H, double factor, const Vector3& x, const RowPolynomials& r)
{
  add_block(H, 0, along_a, -factor * cross_matrix(r.b));
  add_block(H, 0, along_b, factor * cross_matrix(r.a));
  add_block(H, along_a, along_b, -factor * cross_matrix(x));
}

Hessian row_hessian(const BasisTable& table, const CurvedPoints& s, const CurvatureDensity& density,
  double pressure, const Row3& origin, int q)
{
  const RowPolynomials r(s, q);
  const RowDensity F = row_density(table, s, density, q, r.Q);
  Hessian H;
  H.noalias() = (F.PP * r.dP) * r.dP.transpose();
  H.noalias() += (F.QQ * r.dQ) * r.dQ.transpose();
  add_symmetric(H, F.PQ, r.dP, r.dQ);
  add_second_derivatives(H, r, F);
  add_volume(
    H, -pressure * table.weight[q] / 3, (s.points.position.row(q) - origin).transpose(), r);
  return H;
}

/// Cᵀ L C for each pair of components, the rows of an element below one another.
struct ElementMatrix
{
  Eigen::MatrixXd weights;                   // C
  std::array<Eigen::MatrixXd, 6> weighted;   // L C of the pairs xx, yx, yy, zx, zy, zz
  std::array<Eigen::MatrixXd, 6> components; // of nodes by nodes

  static int pair(int d, int e) { return d * (d + 1) / 2 + e; }

  ElementMatrix(Eigen::Index rows, Eigen::Index nodes) : weights(fields * rows, nodes)
  {
    weighted.fill(Eigen::MatrixXd(fields * rows, nodes));
  }
  void set(int row, const Hessian& H)
  {
    const auto C = weights.middleRows<fields>(fields * row);
    for (int d = 0; d < 3; ++d)
      for (int e = 0; e <= d; ++e)
      {
        Eigen::Matrix<double, fields, fields> L;
        for (int i = 0; i < fields; ++i)
          for (int j = 0; j < fields; ++j)
            L(i, j) = H(3 * i + d, 3 * j + e);
        weighted[pair(d, e)].middleRows<fields>(fields * row).noalias() = L * C;
      }
  }
  void multiply()
  {
    for (int p = 0; p < 6; ++p)
      components[p].noalias() = weights.transpose() * weighted[p];
  }
  Eigen::Matrix3d block(Eigen::Index j, Eigen::Index k) const
  {
    Eigen::Matrix3d b;
    for (int d = 0; d < 3; ++d)
      for (int e = 0; e < 3; ++e)
        b(d, e) = d >= e ? components[pair(d, e)](j, k) : components[pair(e, d)](k, j);
    return b;
  }
};

}

CurvedPoints::CurvedPoints(const BasisTable& table, const Points& control)
  : points(evaluate(table, control)), second(second_derivatives(table, control)),
    twice_mean(2 * mean_curvature(points, second))
{
}

Eigen::VectorXd curvature_gradient(
  const BasisTable& table, const CurvedPoints& surface, const CurvatureDensity& density)
{
  Points gradient = Points::Zero(table.nodes, 3);
  for (int q = 0; q < table.rows(); ++q)
  {
    const RowPolynomials r(surface, q);
    const RowDensity F = row_density(table, surface, density, q, r.Q);
    const Gradient g = F.P * r.dP + F.Q * r.dQ;
    for (int k = table.start[q]; k < table.start[q + 1]; ++k)
      gradient.row(table.node[k]) += (table.du[k] * g.segment<3>(3) +
        table.dv[k] * g.segment<3>(6) + table.duu[k] * g.segment<3>(9) +
        table.duv[k] * g.segment<3>(12) + table.dvv[k] * g.segment<3>(15))
                                       .transpose();
  }
  return gradient.reshaped<Eigen::RowMajor>();
}

SecondVariation::SecondVariation(const BasisTable& table) : table_(table)
{
  std::vector<std::vector<int>> below(table.nodes); // rows of each column of blocks
  const auto for_each_pair = [&](auto visit)
  {
    for_each_element(table,
      [&](int, int, std::span<const int> nodes)
      {
        for (const int j : nodes)
          for (const int k : nodes)
            visit(j, k);
      });
  };
  for_each_pair(
    [&](int j, int k)
    {
      if (j >= k)
        below[k].push_back(j);
    });
  Eigen::VectorXi entries(3 * table.nodes);
  for (int k = 0; k < table.nodes; ++k)
  {
    std::ranges::sort(below[k]);
    below[k].erase(std::unique(below[k].begin(), below[k].end()), below[k].end());
    for (int e = 0; e < 3; ++e)
      entries[3 * k + e] = 3 * static_cast<int>(below[k].size()) - e;
  }
  pattern_.resize(3L * table.nodes, 3L * table.nodes);
  pattern_.resizeNonZeros(entries.sum());
  int* outer = pattern_.outerIndexPtr();
  for (int column = 0; column < 3 * table.nodes; ++column)
  {
    const int k = column / 3, e = column % 3;
    int* inner = pattern_.innerIndexPtr() + outer[column];
    for (const int j : below[k])
      for (int d = j == k ? e : 0; d < 3; ++d)
        *inner++ = 3 * j + d;
    outer[column + 1] = outer[column] + entries[column];
  }
  Eigen::Map<Eigen::VectorXd>(pattern_.valuePtr(), pattern_.nonZeros()).setZero();
  for_each_pair(
    [&](int j, int k)
    {
      const auto at = std::ranges::lower_bound(below[k], j);
      block_.push_back(j >= k ? static_cast<int>(at - below[k].begin()) : -1);
    });
}

Eigen::SparseMatrix<double> SecondVariation::matrix(const CurvedPoints& surface,
  const CurvatureDensity& density, double pressure, const NodeFrames& frames) const
{
  Eigen::SparseMatrix<double> result = pattern_;
  const Row3 origin = surface.points.area_weight.transpose() * surface.points.position /
    surface.points.area_weight.sum();
  using Frame = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;
  std::size_t pair = 0;
  for_each_element(table_,
    [&](int begin, int end, std::span<const int> nodes)
    {
      const auto count = static_cast<Eigen::Index>(nodes.size());
      ElementMatrix element(end - begin, count);
      for (int q = begin; q < end; ++q)
      {
        for (int k = 0; k < count; ++k)
        {
          const auto w = weights_of(table_, table_.start[q] + k);
          element.weights.col(k).segment<fields>(fields * (q - begin)) =
            Eigen::Map<const Eigen::Matrix<double, fields, 1>>(w.data());
        }
        element.set(q - begin, row_hessian(table_, surface, density, pressure, origin, q));
      }
      element.multiply();
      for (int j = 0; j < count; ++j)
        for (int k = 0; k < count; ++k, ++pair)
        {
          const int place = block_[pair];
          if (place < 0)
            continue;
          const Frame at_j(frames.row(nodes[j]).data()), at_k(frames.row(nodes[k]).data());
          const Eigen::Matrix3d b = at_j * element.block(j, k) * at_k.transpose();
          for (int e = 0; e < 3; ++e)
          {
            // The first block of a column is the diagonal's, of which the upper part isn't there.
            double* column = result.valuePtr() + result.outerIndexPtr()[3 * nodes[k] + e];
            for (int d = place == 0 ? e : 0; d < 3; ++d)
              column[place == 0 ? d - e : 3 * place - e + d] += b(d, e);
          }
        }
    });
  return result;
}

}
