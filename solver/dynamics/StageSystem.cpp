#include "solver/dynamics/StageSystem.h"

#include "solver/Errors.h"
#include "solver/ParallelFor.h"
#include "solver/linear/Gmres.h"
#include "solver/dynamics/Preconditioner.h"

#include <fmt/format.h>

#include <cmath>

namespace vesicle
{

StageSystem::StageSystem(const SystemShape& shape, const std::vector<Mobility>& mobility,
  double tau, const Eigen::VectorXd& reference)
  : shape_(shape), known_(shape.imposed), of_vesicle_(shape.vesicles.size())
{
  for (std::size_t v = 0; v < shape.vesicles.size(); ++v)
  {
    known_ += mobility[v].velocity(shape.vesicles[v].force());
    add_vesicle(
      v, mobility[v], tau, reference.size() > 0 ? shape.part(reference, v) : Eigen::VectorXd());
  }
}

void StageSystem::add_vesicle(
  std::size_t v, const Mobility& mobility, double tau, const Eigen::VectorXd& reference)
{
  const VesicleShape& shape = shape_.vesicles[v];
  const auto place = [&](int& number, StageBlock block)
  {
    number = static_cast<int>(blocks_.size());
    add(std::move(block));
  };
  if (shape.linearisation && tau > 0)
    place(of_vesicle_[v].stiff, stiff_block(shape, v, mobility, tau, reference));
  if (shape.constraint)
    place(of_vesicle_[v].tension, tension_block(shape, v, mobility));
  if (shape.vesicle->conserved)
    place(of_vesicle_[v].volume, volume_block(shape, v));
}

void StageSystem::add(StageBlock block)
{
  first_.push_back(first_.back() + block.size);
  blocks_.push_back(std::move(block));
}

Eigen::VectorXd StageSystem::velocity_of(const Eigen::VectorXd& y) const
{
  Eigen::VectorXd u = Eigen::VectorXd::Zero(3 * shape_.vertices());
  for (std::size_t b = 0; b < blocks_.size(); ++b)
  {
    const StageBlock& block = blocks_[b];
    if (block.columns)
      u += multiply(*block.columns, y.segment(first_[b], block.count), block.first);
    else
      u.segment(3 * shape_.first[block.vesicle], block.velocity.size()) +=
        y[first_[b]] * block.velocity;
  }
  return u;
}

Eigen::VectorXd StageSystem::rows_of(const Eigen::VectorXd& u) const
{
  Eigen::VectorXd result = Eigen::VectorXd::Zero(unknowns());
  for (std::size_t b = 0; b < blocks_.size(); ++b)
  {
    const auto& [direct, weight, functional] = blocks_[b].rows;
    const Eigen::VectorXd own = shape_.part(u, blocks_[b].vesicle);
    auto rows = result.segment(first_[b], blocks_[b].size);
    if (direct.size() > 0)
      rows += direct * own;
    if (functional.size() > 0)
      rows += weight * (functional * own);
  }
  return result;
}

Eigen::VectorXd StageSystem::apply(const Eigen::VectorXd& y) const
{
  Eigen::VectorXd result = rows_of(velocity_of(y));
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    if (blocks_[b].own.size() > 0)
      result.segment(first_[b], blocks_[b].size) +=
        blocks_[b].own * y.segment(first_[b], blocks_[b].size);
  return result;
}

Eigen::VectorXd StageSystem::right_side() const
{
  Eigen::VectorXd b = -rows_of(known_);
  for (std::size_t k = 0; k < blocks_.size(); ++k)
    if (blocks_[k].prescribed.size() > 0)
      b.segment(first_[k], blocks_[k].size) += blocks_[k].prescribed;
  return b;
}

StageSolution StageSystem::solve(
  const Preconditioner& preconditioner, double tolerance, int max_iterations) const
{
  if (unknowns() == 0)
    return solution_of({});
  // Rows of bending, incompressibility and volume have different units: scaled, one tolerance fits
  // all.
  const Eigen::VectorXd scale = preconditioner.row_scale();
  const GmresResult linear =
    gmres([&](const Eigen::VectorXd& y) -> Eigen::VectorXd { return apply(y).cwiseProduct(scale); },
      [&](const Eigen::VectorXd& r) { return preconditioner.solve(r.cwiseQuotient(scale)); },
      right_side().cwiseProduct(scale), tolerance, max_iterations);
  if (!linear.solution.allFinite() || !std::isfinite(linear.residual))
    throw NumericalError(
      fmt::format("the linear system of {} unknowns has no finite solution", unknowns()));
  if (linear.residual > tolerance)
    throw NumericalError(fmt::format(
      "the linear solve of {} unknowns did not converge: residual {:.1e} after {} iterations",
      unknowns(), linear.residual, linear.iterations));
  StageSolution result = solution_of(linear.solution);
  result.iterations = linear.iterations;
  return result;
}

StageSolution StageSystem::solution_of(const Eigen::VectorXd& y) const
{
  StageSolution result{ known_, {}, 0 };
  if (y.size() > 0)
    result.velocity += velocity_of(y);
  for (std::size_t v = 0; v < shape_.vesicles.size(); ++v)
  {
    const auto& [stiff, tension, volume] = of_vesicle_[v];
    const Eigen::Index n = shape_.first[v + 1] - shape_.first[v];
    StageSolution::Part& part = result.vesicles.emplace_back();
    part.stiff_force = shape_.vesicles[v].stiff_force;
    if (stiff >= 0)
      part.stiff_force += y.segment(first_[stiff], n);
    if (tension >= 0)
      part.tension = y.segment(first_[tension], n);
    if (volume >= 0)
      part.volume_speed = y[first_[volume]];
  }
  return result;
}

namespace
{

/// Rows of a dense matrix in single precision, 3 a node.
using RowsF = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// target += (row i of a sparse matrix) · rows
template<class Target>
void add_row_product(
  Target&& target, const SparseMatrix& sparse, Eigen::Index i, const Eigen::Ref<const RowsF>& rows)
{
  for (SparseMatrix::InnerIterator it(sparse, i); it; ++it)
    target += static_cast<float>(it.value()) * rows.row(it.col());
}

}

Eigen::MatrixXf StageSystem::dense() const
{
  // X: the velocity that each unknown makes, 3N by unknowns.
  RowsF X = RowsF::Zero(3 * shape_.vertices(), unknowns());
  for (std::size_t b = 0; b < blocks_.size(); ++b)
  {
    const StageBlock& block = blocks_[b];
    if (block.columns)
      parallel_for(X.rows(),
        [&](Eigen::Index i)
        {
          X.row(i).segment(first_[b], block.count) =
            block.columns->row(i).segment(block.first, block.count).cast<float>();
        });
    else
      X.col(first_[b]).segment(3 * shape_.first[block.vesicle], block.velocity.size()) =
        block.velocity.cast<float>();
  }
  const auto slice = [&](std::size_t vesicle)
  {
    return X.middleRows(
      3 * shape_.first[vesicle], 3 * (shape_.first[vesicle + 1] - shape_.first[vesicle]));
  };
  std::vector<RowsF> functionals;
  for (const StageBlock& block : blocks_)
    functionals.push_back(block.rows.functional.size() > 0
        ? RowsF(block.rows.functional.cast<float>() * slice(block.vesicle))
        : RowsF());

  RowsF matrix = RowsF::Zero(unknowns(), unknowns());
  for (std::size_t b = 0; b < blocks_.size(); ++b)
  {
    const StageBlock& block = blocks_[b];
    const VelocityRows& rows = block.rows;
    const Eigen::Ref<const RowsF> velocities = slice(block.vesicle);
    parallel_for(block.size,
      [&](Eigen::Index i)
      {
        auto row = matrix.row(first_[b] + i);
        if (rows.direct.size() > 0)
          add_row_product(row, rows.direct, i, velocities);
        for (Eigen::Index k = 0; k < rows.weight.cols(); ++k)
          row += static_cast<float>(rows.weight(i, k)) * functionals[b].row(k);
        if (block.own.size() > 0)
          for (SparseMatrix::InnerIterator it(block.own, i); it; ++it)
            row[first_[b] + it.col()] += static_cast<float>(it.value());
      });
  }
  return matrix;
}

}
