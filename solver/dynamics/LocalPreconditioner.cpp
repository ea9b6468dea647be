#include "solver/dynamics/LocalPreconditioner.h"

#include "solver/Errors.h"
#include "solver/dynamics/LoadStage.h"

#include <Eigen/LU>

#include <cmath>
#include <numbers>

namespace vesicle
{

namespace
{

SparseMatrix layer_inverse(const Surface& surface)
{
  const double nodes = static_cast<double>(surface.vertices.rows()),
               radius = std::sqrt(surface.area / (4 * std::numbers::pi)),
               k0 = 2 * std::pow(nodes, 0.25) / radius;
  const BasisTable& table = surface.space->table();
  return 2 / k0 * stiffness_matrix(table, surface.points) +
    2 * k0 * mass_matrix(table, surface.points);
}

/// What R feels of normal motions of the nodes: #rows by N. Entries come in threes, a node's.
SparseMatrix along_normals(const SparseMatrix& R, const Points& normals)
{
  SparseMatrix along(R.rows(), R.cols() / 3);
  along.resizeNonZeros(R.nonZeros() / 3);
  for (int q = 0; q <= R.rows(); ++q)
    along.outerIndexPtr()[q] = R.outerIndexPtr()[q] / 3;
  for (Eigen::Index k = 0; k < R.nonZeros() / 3; ++k)
  {
    const int node = R.innerIndexPtr()[3 * k] / 3;
    along.innerIndexPtr()[k] = node;
    along.valuePtr()[k] =
      Eigen::Map<const Eigen::RowVector3d>(R.valuePtr() + 3 * k).dot(normals.row(node));
  }
  return along;
}

SparseMatrix gram(const SparseMatrix& R)
{
  return SparseMatrix(R.transpose()) * R;
}

SparseMatrix three_times(const SparseMatrix& scalar)
{
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < scalar.rows(); ++i)
    for (SparseMatrix::InnerIterator it(scalar, i); it; ++it)
      for (int d = 0; d < 3; ++d)
        entries.emplace_back(3 * i + d, 3 * static_cast<int>(it.col()) + d, it.value());
  SparseMatrix result(3 * scalar.rows(), 3 * scalar.cols());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

SymmetricMatrix saddle_matrix(const SparseMatrix& layer_inverse, const ConstraintRows* constraint)
{
  const Eigen::Index n = layer_inverse.rows();
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i)
    for (SparseMatrix::InnerIterator it(layer_inverse, i); it; ++it)
      for (int d = 0; d < 3; ++d)
        entries.emplace_back(3 * i + d, 3 * static_cast<int>(it.col()) + d, it.value());
  if (constraint)
  {
    const int first = static_cast<int>(3 * n);
    for (int i = 0; i < n; ++i)
    {
      for (SparseMatrix::InnerIterator it(constraint->rate, i); it; ++it)
      {
        entries.emplace_back(first + i, static_cast<int>(it.col()), it.value());
        entries.emplace_back(static_cast<int>(it.col()), first + i, it.value());
      }
      for (SparseMatrix::InnerIterator it(constraint->filter, i); it; ++it)
        entries.emplace_back(first + i, first + static_cast<int>(it.col()), it.value());
    }
  }
  const Eigen::Index size = constraint ? 4 * n : 3 * n;
  SymmetricMatrix result(size, size);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

void require(const SparseCholesky& factors)
{
  if (factors.info() != Eigen::Success)
    throw NumericalError("the preconditioner of a stage is singular");
}

}

void LocalPreconditioner::build(const VesicleLoads& loads)
{
  const Surface& surface = loads.surface();
  nodes_ = surface.vertices.rows();
  layer_inverse_ = layer_inverse(surface);
  has_tension_ = loads.has_tension();
  taut_ = loads.taut();
  saddle_.compute(saddle_matrix(layer_inverse_, has_tension_ ? &loads.constraint() : nullptr));
  require(saddle_);
  volume_rate_ = loads.volume_rate();
  vertex_area_ = surface.vertex_area;
  pushed_normal_ = flat(Points(layer_inverse_ * rows_of_three(loads.normal())));
  const double pushed = pushed_normal_.dot(loads.normal());
  Eigen::MatrixXd right_sides =
    Eigen::MatrixXd::Zero((has_tension_ ? 4 : 3) * nodes_, taut_ ? 3 : 2);
  right_sides.col(0).head(3 * nodes_) = -volume_rate_;
  right_sides.col(1).head(3 * nodes_) = pushed_normal_;
  if (taut_)
    right_sides.col(2).tail(nodes_) = -vertex_area_;
  columns_ = saddle_.solve(right_sides);
  border_.resize(columns_.cols(), columns_.cols());
  for (Eigen::Index k = 0; k < columns_.cols(); ++k)
    border_.col(k) = border_rows(columns_.col(k));
  border_(1, 1) -= pushed;
}

Eigen::VectorXd LocalPreconditioner::border_rows(const Eigen::VectorXd& y) const
{
  Eigen::VectorXd rows(taut_ ? 3 : 2);
  rows[0] = volume_rate_.dot(y.head(3 * nodes_));
  rows[1] = pushed_normal_.dot(y.head(3 * nodes_));
  if (taut_)
    rows[2] = vertex_area_.dot(y.tail(nodes_));
  return rows;
}

void LocalPreconditioner::build_stiff(const VesicleLoads& loads, double tau)
{
  const Points& normals = loads.surface().normals;
  const bool material = loads.motion().kind() == NodeMotionKind::material;
  layer_inverse_now_ = layer_inverse(loads.surface());
  if (material)
    layer_inverse_now_ = three_times(layer_inverse_now_);
  SparseMatrix sum = layer_inverse_now_;
  if (tau > 0 && loads.stiff())
    sum += 2 * tau * gram(material ? loads.rates() : along_normals(loads.rates(), normals));
  if (loads.taut())
    sum += 2 * gram(along_normals(loads.resisting_rates(), normals));
  stiff_.compute(SymmetricMatrix(sum));
  require(stiff_);
}

LoadUnknowns LocalPreconditioner::solve(
  const VesicleLoads& loads, const LoadUnknowns& residual) const
{
  LoadUnknowns x;
  const Collocation& collocation = loads.surface().collocation();
  if (residual.parameters.size() > 0)
  {
    if (loads.motion().kind() == NodeMotionKind::normal)
      x.parameters = collocation.at_vertices(Eigen::VectorXd(
        stiff_.solve(layer_inverse_now_ * Eigen::VectorXd(collocation.fit(residual.parameters)))));
    else
      x.parameters = stiff_.solve(layer_inverse_now_ * residual.parameters);
  }
  Eigen::VectorXd y = Eigen::VectorXd::Zero(columns_.rows()), wanted(columns_.cols());
  wanted.head(2) << residual.pressure, residual.volume_speed;
  if (has_tension_)
  {
    y.tail(nodes_) = residual.tension;
    y = Eigen::VectorXd(saddle_.solve(y));
  }
  if (taut_)
    wanted[2] = -residual.tension.sum() / VesicleLoads::gauge;
  const Eigen::VectorXd amounts =
    border_.partialPivLu().solve(Eigen::VectorXd(wanted - border_rows(y)));
  y += columns_ * amounts;
  x.pressure = amounts[0];
  x.volume_speed = amounts[1];
  if (has_tension_)
    x.tension = y.tail(nodes_);
  return x;
}

}
