#include "solver/dynamics/StageProblem.h"

#include "solver/Errors.h"
#include "solver/dynamics/Gmres.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

namespace vesicle
{

namespace
{

using RowsF = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using RowVectorF = Eigen::RowVectorXf;

// target += factor · (sparse row i) · rows
template<class Target>
void add_row_product(
  Target&& target, double factor, const SparseMatrix& sparse, int i, const RowsF& rows)
{
  for (SparseMatrix::InnerIterator it(sparse, i); it; ++it)
    target += static_cast<float>(factor * it.value()) * rows.row(it.col());
}

}

StageProblem::StageProblem(
  const Model& model, const ShapeOperators& shape, const DenseMatrix& S, double tau)
  : model_(model), shape_(shape), S_(S), tau_(tau), nodes_(static_cast<int>(shape.normal.rows()))
{
  total_ = model.bending ? nodes_ : 0;
  tension_ = model.incompressible ? total_ : -1;
  total_ += model.incompressible ? nodes_ : 0;
  volume_ = model.robust() ? total_ : -1;
  total_ += model.robust() ? 1 : 0;
  slack_ = shape.gauge_pinned ? total_ : -1;
  total_ += shape.gauge_pinned ? 1 : 0;
}

Eigen::VectorXd StageProblem::relative_to_centroid(
  const ShapeOperators& shape, const Eigen::VectorXd& velocity)
{
  const Vector3 mean = shape.centroid_velocity * velocity;
  return velocity - mean.replicate(velocity.size() / 3, 1);
}

Eigen::VectorXd StageProblem::velocity_of(const Eigen::VectorXd& y) const
{
  Eigen::VectorXd force = Eigen::VectorXd::Zero(3 * nodes_), u;
  if (model_.bending)
    force += flat((shape_.normal.array().colwise() * y.head(nodes_).array()).matrix().eval());
  if (tension_ >= 0)
    force += shape_.tension_force * y.segment(tension_, nodes_);
  multiply(S_, force, u);
  if (volume_ >= 0)
    u += y[volume_] * flat(shape_.outward);
  return u;
}

Eigen::VectorXd StageProblem::apply(const Eigen::VectorXd& y) const
{
  const Eigen::VectorXd u = velocity_of(y);
  Eigen::VectorXd result(total_);
  if (model_.bending)
    result.head(nodes_) =
      y.head(nodes_) - tau_ * (shape_.bending_response * relative_to_centroid(shape_, u));
  if (tension_ >= 0)
    result.segment(tension_, nodes_) = shape_.divergence * u;
  if (volume_ >= 0)
    result[volume_] = shape_.volume_gradient.dot(u);
  if (slack_ >= 0)
  {
    result.segment(tension_, nodes_) += y[slack_] * shape_.divergence * flat(shape_.outward);
    result[slack_] = shape_.vertex_area.dot(y.segment(tension_, nodes_));
  }
  return result;
}

Eigen::VectorXd StageProblem::known_velocity() const
{
  Eigen::VectorXd u = Eigen::VectorXd::Zero(3 * nodes_);
  if (model_.bending || model_.bond != 0)
  {
    Eigen::VectorXd force = Eigen::VectorXd::Zero(3 * nodes_);
    if (model_.bending)
      force += flat((shape_.normal.array().colwise() * shape_.bending.array()).matrix().eval());
    if (model_.bond != 0)
      force += shape_.load;
    multiply(S_, force, u);
  }
  if (model_.flow)
    u += shape_.ambient;
  return u;
}

StageSolution StageProblem::solve(const DenseFactorization& preconditioner, double tolerance,
  int max_iterations, const Eigen::VectorXd& reference) const
{
  const Eigen::VectorXd known = known_velocity();
  StageSolution result{ known, shape_.bending, {}, 0, 0 };
  if (total_ == 0)
    return result;

  Eigen::VectorXd b = Eigen::VectorXd::Zero(total_);
  if (model_.bending)
  {
    Eigen::VectorXd relative = relative_to_centroid(shape_, known);
    if (reference.size() > 0)
      relative -= reference;
    b.head(nodes_) = tau_ * (shape_.bending_response * relative);
  }
  if (tension_ >= 0)
    b.segment(tension_, nodes_) = -(shape_.divergence * known);
  if (volume_ >= 0)
    b[volume_] = -shape_.volume_gradient.dot(known);

  const GmresResult linear = gmres([this](const Eigen::VectorXd& y) { return apply(y); },
    [&](const Eigen::VectorXd& r) { return preconditioner.solve(r); }, b, tolerance,
    max_iterations);
  if (!linear.solution.allFinite() || !(linear.residual <= tolerance))
    throw NumericalError(fmt::format(
      "the linear solve of {} unknowns did not converge: residual {:.1e} after {} iterations",
      total_, linear.residual, linear.iterations));

  const Eigen::VectorXd& y = linear.solution;
  result.velocity += velocity_of(y);
  if (model_.bending)
    result.bending += y.head(nodes_);
  if (tension_ >= 0)
    result.tension = y.segment(tension_, nodes_);
  if (volume_ >= 0)
    result.volume_speed = y[volume_];
  result.iterations = linear.iterations;
  return result;
}

DenseFactorization::Matrix StageProblem::dense() const
{
  // X: the velocity that each unknown makes, 3N by unknowns, row by row of S.
  RowsF X = RowsF::Zero(3 * nodes_, total_);
  tbb::parallel_for(0, 3 * nodes_,
    [&](int i)
    {
      const double* s = S_.row(i).data();
      if (model_.bending)
        for (int j = 0; j < nodes_; ++j)
          X(i, j) = static_cast<float>(shape_.normal(j, 0) * s[3 * j] +
            shape_.normal(j, 1) * s[3 * j + 1] + shape_.normal(j, 2) * s[3 * j + 2]);
      if (tension_ >= 0)
      {
        Eigen::VectorXd row = Eigen::VectorXd::Zero(nodes_);
        for (int k = 0; k < 3 * nodes_; ++k)
          for (SparseMatrix::InnerIterator it(shape_.tension_force, k); it; ++it)
            row[it.col()] += s[k] * it.value();
        X.row(i).segment(tension_, nodes_) = row.cast<float>().transpose();
      }
      if (volume_ >= 0)
        X(i, volume_) = static_cast<float>(shape_.outward(i / 3, i % 3));
    });

  RowsF matrix = RowsF::Zero(total_, total_);
  if (model_.bending)
  {
    // The response to the centroid's velocity is taken out: R E W X, E one identity a node.
    Eigen::Matrix<double, Eigen::Dynamic, 3> uniform(nodes_, 3);
    for (int c = 0; c < 3; ++c)
    {
      Eigen::VectorXd direction = Eigen::VectorXd::Zero(3 * nodes_);
      for (int j = 0; j < nodes_; ++j)
        direction[3 * j + c] = 1;
      uniform.col(c) = shape_.bending_response * direction;
    }
    const RowsF centroid = shape_.centroid_velocity.cast<float>() * X;
    tbb::parallel_for(0, nodes_,
      [&](int i)
      {
        auto row = matrix.row(i);
        add_row_product(row, -tau_, shape_.bending_response, i, X);
        for (int c = 0; c < 3; ++c)
          row += static_cast<float>(tau_ * uniform(i, c)) * centroid.row(c);
        row[i] += 1;
      });
  }
  if (tension_ >= 0)
    tbb::parallel_for(0, nodes_,
      [&](int i) { add_row_product(matrix.row(tension_ + i), 1, shape_.divergence, i, X); });
  if (volume_ >= 0)
    matrix.row(volume_) = shape_.volume_gradient.transpose().cast<float>() * X;
  if (slack_ >= 0)
  {
    matrix.col(slack_).segment(tension_, nodes_) =
      (shape_.divergence * flat(shape_.outward)).cast<float>();
    matrix.row(slack_).segment(tension_, nodes_) = shape_.vertex_area.transpose().cast<float>();
  }
  return matrix;
}

}
