#include "solver/dynamics/StageProblem.h"

#include "solver/Errors.h"
#include "solver/dynamics/Gmres.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

namespace vesicle
{

namespace
{

using RowsF = Discretization::RowsF;

// target += factor · (sparse row i) · rows
template<class Target>
void add_row_product(
  Target&& target, double factor, const SparseMatrix& sparse, int i, const RowsF& rows)
{
  for (SparseMatrix::InnerIterator it(sparse, i); it; ++it)
    target += static_cast<float>(factor * it.value()) * rows.row(it.col());
}

}

StageProblem::StageProblem(const Model& model, const Discretization& discretization,
  const ShapeOperators& shape, const VelocityResponse& response, double tau)
  : model_(model), discretization_(discretization), shape_(shape), response_(response), tau_(tau),
    nodes_(static_cast<int>(shape.vertices.rows()))
{
  total_ = 0;
  const auto place = [this](bool present, int size)
  {
    const int first = total_;
    total_ += present ? size : 0;
    return present ? first : -1;
  };
  bending_ = place(model.bending && tau > 0, nodes_);
  tension_ = place(model.incompressible, nodes_);
  volume_ = place(model.robust(), 1);
  slack_ = place(shape.gauge_pinned, 1);
}

Eigen::VectorXd StageProblem::relative_to_centroid(
  const ShapeOperators& shape, const Eigen::VectorXd& velocity)
{
  const Vector3 mean = shape.centroid_velocity * velocity;
  return velocity - mean.replicate(velocity.size() / 3, 1);
}

Eigen::VectorXd StageProblem::part(const Eigen::VectorXd& y, int first) const
{
  return first < 0 ? Eigen::VectorXd() : Eigen::VectorXd(y.segment(first, nodes_));
}

Eigen::VectorXd StageProblem::velocity_of(const Eigen::VectorXd& y) const
{
  Eigen::VectorXd u = response_.velocity(part(y, bending_), part(y, tension_));
  if (u.size() == 0)
    u = Eigen::VectorXd::Zero(3 * nodes_);
  if (volume_ >= 0)
    u += y[volume_] * flat(shape_.outward);
  return u;
}

Eigen::VectorXd StageProblem::apply(const Eigen::VectorXd& y) const
{
  const Eigen::VectorXd u = velocity_of(y);
  Eigen::VectorXd result(total_);
  if (bending_ >= 0)
  {
    const Eigen::VectorXd psi = part(y, bending_);
    result.segment(bending_, nodes_) =
      (shape_.bending_mass.size() > 0 ? Eigen::VectorXd(shape_.bending_mass * psi) : psi) -
      tau_ *
        (shape_.bending_response * discretization_.to_control(relative_to_centroid(shape_, u)));
  }
  if (tension_ >= 0)
  {
    result.segment(tension_, nodes_) = shape_.divergence * discretization_.to_control(u);
    if (shape_.divergence_filter.size() > 0)
      result.segment(tension_, nodes_) += shape_.divergence_filter * part(y, tension_);
  }
  if (volume_ >= 0)
    result[volume_] = shape_.volume_gradient.dot(u);
  if (slack_ >= 0)
  {
    result.segment(tension_, nodes_) += y[slack_] * slack_column();
    result[slack_] = shape_.vertex_area.dot(y.segment(tension_, nodes_));
  }
  return result;
}

Eigen::VectorXd StageProblem::slack_column() const
{
  return shape_.divergence * discretization_.to_control(flat(shape_.outward));
}

Eigen::VectorXd StageProblem::known_velocity() const
{
  Eigen::VectorXd u = response_.velocity(shape_.bending, {});
  if (u.size() == 0)
    u = Eigen::VectorXd::Zero(3 * nodes_);
  if (response_.load.size() > 0)
    u += response_.load;
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
  if (bending_ >= 0)
  {
    Eigen::VectorXd relative = relative_to_centroid(shape_, known);
    if (reference.size() > 0)
      relative -= reference;
    b.segment(bending_, nodes_) =
      tau_ * (shape_.bending_response * discretization_.to_control(relative));
  }
  if (tension_ >= 0)
    b.segment(tension_, nodes_) = -(shape_.divergence * discretization_.to_control(known));
  if (volume_ >= 0)
    b[volume_] = -shape_.volume_gradient.dot(known);

  // Rows of bending, incompressibility and volume have different units: scaled, one tolerance fits
  // all.
  const Eigen::VectorXd scale = preconditioner.row_scale();
  const GmresResult linear =
    gmres([&](const Eigen::VectorXd& y) -> Eigen::VectorXd { return apply(y).cwiseProduct(scale); },
      [&](const Eigen::VectorXd& r) { return preconditioner.solve(r.cwiseQuotient(scale)); },
      b.cwiseProduct(scale), tolerance, max_iterations);
  if (!linear.solution.allFinite() || !(linear.residual <= tolerance))
    throw NumericalError(fmt::format(
      "the linear solve of {} unknowns did not converge: residual {:.1e} after {} iterations",
      total_, linear.residual, linear.iterations));

  const Eigen::VectorXd& y = linear.solution;
  result.velocity += velocity_of(y);
  if (bending_ >= 0)
    result.bending += part(y, bending_);
  result.tension = part(y, tension_);
  if (volume_ >= 0)
    result.volume_speed = y[volume_];
  result.iterations = linear.iterations;
  return result;
}

DenseFactorization::Matrix StageProblem::dense() const
{
  // X: the velocity that each unknown makes, 3N by unknowns; then that of the control points.
  RowsF X = RowsF::Zero(3 * nodes_, total_);
  tbb::parallel_for(0, 3 * nodes_,
    [&](int i)
    {
      if (bending_ >= 0)
        X.row(i).segment(bending_, nodes_) = response_.normal.row(i).cast<float>();
      if (tension_ >= 0)
        X.row(i).segment(tension_, nodes_) = response_.tension.row(i).cast<float>();
      if (volume_ >= 0)
        X(i, volume_) = static_cast<float>(shape_.outward(i / 3, i % 3));
    });
  const RowsF centroid = shape_.centroid_velocity.cast<float>() * X;
  const RowsF volume = shape_.volume_gradient.transpose().cast<float>() * X;
  discretization_.to_control(X);

  RowsF matrix = RowsF::Zero(total_, total_);
  if (bending_ >= 0)
  {
    // The response to the centroid's velocity is taken out: R E W X, E one identity a node.
    Eigen::Matrix<double, Eigen::Dynamic, 3> uniform(nodes_, 3);
    for (int c = 0; c < 3; ++c)
      uniform.col(c) = shape_.bending_response * Vector3(Vector3::Unit(c)).replicate(nodes_, 1);
    tbb::parallel_for(0, nodes_,
      [&](int i)
      {
        auto row = matrix.row(bending_ + i);
        add_row_product(row, -tau_, shape_.bending_response, i, X);
        for (int c = 0; c < 3; ++c)
          row += static_cast<float>(tau_ * uniform(i, c)) * centroid.row(c);
        if (shape_.bending_mass.size() == 0)
          row[bending_ + i] += 1;
        else
          for (SparseMatrix::InnerIterator it(shape_.bending_mass, i); it; ++it)
            row[bending_ + it.col()] += static_cast<float>(it.value());
      });
  }
  if (tension_ >= 0)
    tbb::parallel_for(0, nodes_,
      [&](int i)
      {
        add_row_product(matrix.row(tension_ + i), 1, shape_.divergence, i, X);
        if (shape_.divergence_filter.size() > 0)
          for (SparseMatrix::InnerIterator it(shape_.divergence_filter, i); it; ++it)
            matrix(tension_ + i, tension_ + it.col()) += static_cast<float>(it.value());
      });
  if (volume_ >= 0)
    matrix.row(volume_) = volume;
  if (slack_ >= 0)
  {
    matrix.col(slack_).segment(tension_, nodes_) = slack_column().cast<float>();
    matrix.row(slack_).segment(tension_, nodes_) = shape_.vertex_area.transpose().cast<float>();
  }
  return matrix;
}

}
