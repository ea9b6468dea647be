#include "solver/surface/HeightFit.h"

#include "solver/mesh/LeastSquares.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace vesicle
{

namespace
{

// Terms that the points don't tell apart (of columns of unit length): a lower degree then.
constexpr double rank_threshold = 1e-6;

Eigen::Map<const Eigen::VectorXd> as_vector(const std::vector<double>& values)
{
  return { values.data(), std::ssize(values) };
}

/// Second-order terms can't follow a sphere far. z ρ²/d² has the same second derivatives at the
/// vertex (in its tangent frame) and makes them exact on a sphere, where 2z/d² is the curvature at
/// any distance d.
double height_as_on_sphere(double x, double y, double z)
{
  const double along = x * x + y * y, distance = along + z * z;
  return distance > 0 ? z * along / distance : 0;
}

}

int HeightFit::unknowns(int degree)
{
  return degree == 1 ? 3 : (degree + 1) * (degree + 2) / 2 - 1;
}

bool HeightFit::compute(const Patch& patch, const Vector3& normal, int degree)
{
  surface_.frame = frame_along(normal);
  degree_ = degree;
  size_ = patch.size;
  const int count = patch.count();
  x_.resize(count);
  y_.resize(count);
  z_.resize(count);
  for (int k = 0; k < count; ++k)
  {
    const Vector3 local = surface_.frame * patch.offset.row(k).transpose() / size_;
    x_[k] = local.x();
    y_[k] = local.y();
    z_[k] = degree > 2 ? local.z() : height_as_on_sphere(local.x(), local.y(), local.z());
  }
  return (degree == 1 ? determine_second_order(patch) : determine(patch, degree)) &&
    surface_.slope.allFinite();
}

// The columns are weight · x, y, x², xy, y², x³ …: each one of the order below times x or y.
bool HeightFit::determine(const Patch& patch, int degree)
{
  const int count = patch.count();
  equations_.resize(count, unknowns(degree));
  const auto multiply = [&](const double* from, const std::vector<double>& by, double* to)
  { std::transform(from, from + count, by.begin(), to, std::multiplies<>()); };
  multiply(patch.weight.data(), x_, equations_.column(0));
  multiply(patch.weight.data(), y_, equations_.column(1));
  for (int order = 2, column = 2; order <= degree; ++order)
  {
    const int below = column - order; // the first column of the order below
    for (int j = 0; j < order; ++j)
      multiply(equations_.column(below + j), x_, equations_.column(column++));
    multiply(equations_.column(below + order - 1), y_, equations_.column(column++));
  }
  multiply(patch.weight.data(), z_, equations_.right_side());
  if (!equations_.solve(rank_threshold))
    return false;
  const auto c = equations_.solution();
  surface_.slope.head<2>() << c[0], c[1];
  describe(patch, { c[2], c[3], c[4] }, equations_.residual(), equations_.leverages());
  return true;
}

// As few points may not determine even these, of all solutions that of least norm.
bool HeightFit::determine_second_order(const Patch& patch)
{
  const auto x = as_vector(x_).array(), y = as_vector(y_).array();
  const auto weight = as_vector(patch.weight);
  Eigen::MatrixXd A(patch.count(), 3);
  A << x * x, x * y, y * y;
  A = weight.asDiagonal() * A;
  const Eigen::VectorXd scale = A.colwise().norm().cwiseMax(1e-300);
  A = A * scale.cwiseInverse().asDiagonal(); // needles: x and y of very different lengths
  const Eigen::MatrixXd inverse = least_norm(A, weight.asDiagonal(), rank_threshold).X;
  const auto z = as_vector(z_);
  second_order_ = scale.cwiseInverse().asDiagonal() * inverse;
  surface_.slope.head<2>().setZero();
  std::vector<double> leverage(patch.count());
  for (int k = 0; k < patch.count(); ++k)
    leverage[k] = A.row(k).dot(inverse.col(k)) / weight[k];
  describe(
    patch, second_order_ * z, (weight.asDiagonal() * z - A * (inverse * z)).norm(), leverage);
  return second_order_.allFinite();
}

// Of residuals r with weights w² noise σ leaves Σ w² r² = σ² Σ w² (1 − leverage) on average.
void HeightFit::describe(const Patch& patch, const Vector3& second_order, double residual,
  std::span<const double> leverage)
{
  constexpr double hardly_any = 1e-6; // of the weights: the fit goes through its points
  surface_.slope.tail<3>() << 2 * second_order[0], second_order[1], 2 * second_order[2];
  surface_.slope.tail<3>() /= size_;
  double weights = 0, free = 0;
  for (int k = 0; k < patch.count(); ++k)
  {
    const double square = patch.weight[k] * patch.weight[k];
    weights += square;
    free += square * (1 - leverage[k]);
  }
  residual_ = size_ * residual / std::sqrt(weights);
  noise_ = free > hardly_any * weights ? size_ * residual / std::sqrt(free) : 0;
}

std::span<const double> HeightFit::laplacian(const Patch& patch)
{
  const Eigen::Vector<double, 5> l = surface_.laplacian();
  const double square = size_ * size_;
  const Vector3 second(2 * l[2] / square, l[3] / square, 2 * l[4] / square);
  laplacian_.resize(patch.count());
  if (degree_ == 1)
  {
    Eigen::Map<Eigen::VectorXd>(laplacian_.data(), patch.count()) =
      second_order_.transpose() * second;
    return laplacian_;
  }
  functional_.assign(unknowns(degree_), 0);
  functional_[0] = l[0] / size_;
  functional_[1] = l[1] / size_;
  std::copy_n(second.data(), 3, functional_.begin() + 2);
  const auto row = equations_.functional(functional_);
  std::transform(
    row.begin(), row.end(), patch.weight.begin(), laplacian_.begin(), std::multiplies<>());
  return laplacian_;
}

double HeightFit::mean_error(std::span<const double> laplacian) const
{
  double sum = 0, squares = 0;
  for (const double l : laplacian)
  {
    sum += l;
    squares += l * l;
  }
  return 0.5 * noise_ * std::sqrt(squares + sum * sum);
}

}
