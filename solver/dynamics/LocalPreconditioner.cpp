#include "solver/dynamics/LocalPreconditioner.h"

#include "solver/Errors.h"
#include "solver/ParallelFor.h"
#include "solver/dynamics/LoadStage.h"
#include "solver/linear/Symmetric.h"

#include <Eigen/LU>

#include <cmath>
#include <numbers>

namespace vesicle
{

SparseMatrix layer_inverse(const VesicleLoads& loads)
{
  const Surface& surface = loads.surface();
  const double nodes = static_cast<double>(surface.vertices.rows()),
               radius = std::sqrt(surface.area / (4 * std::numbers::pi)),
               k0 = 2 * std::pow(nodes, 0.25) / radius,
               viscosity = (1 + loads.viscosity_ratio()) / 2;
  SparseMatrix sum = stiffness_matrix(surface.space->table(), surface.points);
  sum.coeffs() = 2 * viscosity * (sum.coeffs() / k0 + k0 * loads.mass().coeffs()); // of one pattern
  return sum;
}

namespace
{

using Entries = std::vector<Eigen::Triplet<double>>;

template<class Matrix>
Matrix square(Eigen::Index size, const Entries& entries)
{
  Matrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

// scalar ⊗ 1₃.
SparseMatrix three_times(const SparseMatrix& scalar)
{
  Entries entries;
  for (int i = 0; i < scalar.rows(); ++i)
    for (SparseMatrix::InnerIterator it(scalar, i); it; ++it)
      for (int d = 0; d < 3; ++d)
        entries.emplace_back(3 * i + d, 3 * static_cast<int>(it.col()) + d, it.value());
  return square<SparseMatrix>(3 * scalar.rows(), entries);
}

// For vectors, what is scalar for their components along the nodes' normals: n_i scalar_ij n_jᵀ.
SparseMatrix along_normals(const SparseMatrix& scalar, const Points& normals)
{
  Entries entries;
  for (int i = 0; i < scalar.rows(); ++i)
    for (SparseMatrix::InnerIterator it(scalar, i); it; ++it)
      for (int d = 0; d < 3; ++d)
        for (int e = 0; e < 3; ++e)
          entries.emplace_back(3 * i + d, 3 * static_cast<int>(it.col()) + e,
            it.value() * normals(i, d) * normals(it.col(), e));
  return square<SparseMatrix>(3 * scalar.rows(), entries);
}

// A_i ⊗ 1₃ and what else resists the velocities of a viscous membrane.
SparseMatrix resistance_of(const VesicleLoads& loads, const SparseMatrix& layer_inverse, double tau)
{
  const Points& normals = loads.surface().normals;
  const bool material = loads.motion().kind() == NodeMotionKind::material;
  SparseMatrix sum = three_times(layer_inverse) + loads.viscosity();
  if (tau > 0 && loads.stiff())
    sum +=
      tau * (material ? loads.stiffness() : along_normals(loads.stiffness_along(normals), normals));
  if (loads.taut())
    sum += along_normals(loads.resistance(), normals);
  return sum;
}

SymmetricMatrix saddle_matrix(const SparseMatrix& of_velocities, const ConstraintRows* constraint)
{
  const Eigen::Index n = of_velocities.rows() / 3;
  Entries entries;
  for (int i = 0; i < of_velocities.rows(); ++i)
    for (SparseMatrix::InnerIterator it(of_velocities, i); it; ++it)
      entries.emplace_back(i, static_cast<int>(it.col()), it.value());
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
  return square<SymmetricMatrix>(constraint ? 4 * n : 3 * n, entries);
}

void require(bool regular)
{
  if (!regular)
    throw NumericalError("the preconditioner of a stage is singular");
}

}

void LocalPreconditioner::build(const VesicleLoads& loads)
{
  build_saddle(loads, 0);
}

void LocalPreconditioner::build_saddle(const VesicleLoads& loads, double tau)
{
  const Surface& surface = loads.surface();
  nodes_ = surface.vertices.rows();
  const SparseMatrix layer_inverse = vesicle::layer_inverse(loads);
  has_tension_ = loads.has_tension();
  taut_ = loads.taut();
  saddle_.compute(saddle_matrix(loads.viscous() ? resistance_of(loads, layer_inverse, tau)
                                                : three_times(layer_inverse),
                    has_tension_ ? &loads.constraint() : nullptr),
    surface.space->plans());
  require(saddle_.regular());
  volume_rate_ = loads.volume_rate();
  vertex_area_ = surface.vertex_area;
  pushed_normal_ = flat(Points(layer_inverse * rows_of_three(loads.normal())));
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
  if (loads.viscous())
    layer_inverse_ = layer_inverse;
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
  if (loads.viscous())
    return build_saddle(loads, tau);
  const bool material = loads.motion().kind() == NodeMotionKind::material;
  layer_inverse_ = layer_inverse(loads);
  if (material)
    layer_inverse_ = three_times(layer_inverse_);
  SparseMatrix sum = layer_inverse_;
  if (tau > 0 && loads.stiff())
    sum += tau * (material ? loads.stiffness() : loads.stiffness_along(loads.surface().normals));
  if (loads.taut())
    sum += loads.resistance();
  stiff_.compute(by_columns(sum), loads.surface().space->plans());
  require(stiff_.regular());
}

LoadUnknowns LocalPreconditioner::solve(
  const VesicleLoads& loads, const LoadUnknowns& residual) const
{
  LoadUnknowns x;
  if (loads.viscous())
    solve_saddle(loads, residual, x);
  else
    run_together({ [&] { x.parameters = parameters(loads, residual); },
      [&] { solve_saddle(loads, residual, x); } });
  return x;
}

Eigen::VectorXd LocalPreconditioner::parameters(
  const VesicleLoads& loads, const LoadUnknowns& residual) const
{
  if (residual.parameters.size() == 0)
    return {};
  if (loads.motion().kind() != NodeMotionKind::normal)
    return stiff_.solve(layer_inverse_ * residual.parameters);
  const Collocation& collocation = loads.surface().collocation();
  return collocation.at_vertices(Eigen::VectorXd(
    stiff_.solve(layer_inverse_ * Eigen::VectorXd(collocation.fit(residual.parameters)))));
}

// The velocities are ν less its residual r: their rows are those of ν and of what r makes.
void LocalPreconditioner::solve_saddle(
  const VesicleLoads& loads, const LoadUnknowns& residual, LoadUnknowns& x) const
{
  Eigen::VectorXd y = Eigen::VectorXd::Zero(columns_.rows()), wanted(columns_.cols());
  wanted.head(2) << residual.pressure, residual.volume_speed;
  if (has_tension_)
    y.tail(nodes_) = residual.tension;
  if (loads.viscous())
  {
    const Eigen::VectorXd& r = residual.parameters;
    y.head(3 * nodes_) = flat(Points(layer_inverse_ * rows_of_three(r)));
    if (has_tension_)
      y.tail(nodes_) += loads.area_rates(r);
    wanted[0] += volume_rate_.dot(r);
    wanted[1] += pushed_normal_.dot(r);
  }
  if (has_tension_ || loads.viscous())
    y = Eigen::VectorXd(saddle_.solve(y));
  if (taut_)
    wanted[2] = -residual.tension.sum() / VesicleLoads::gauge;
  const Eigen::VectorXd amounts =
    border_.partialPivLu().solve(Eigen::VectorXd(wanted - border_rows(y)));
  y += columns_ * amounts;
  x.pressure = amounts[0];
  x.volume_speed = amounts[1];
  if (loads.viscous())
    x.parameters = y.head(3 * nodes_);
  if (has_tension_)
    x.tension = y.tail(nodes_);
}

}
