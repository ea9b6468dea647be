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

Eigen::Matrix3d frame_of(const Vector3& normal)
{
  Eigen::Matrix3d frame;
  const Vector3 x = normal.unitOrthogonal();
  frame << x.transpose(), normal.cross(x).transpose(), normal.transpose();
  return frame;
}

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
  frame_ = frame_of(normal);
  degree_ = degree;
  size_ = patch.size;
  const int count = patch.count();
  x_.resize(count);
  y_.resize(count);
  z_.resize(count);
  for (int k = 0; k < count; ++k)
  {
    const Vector3 local = frame_ * patch.offset.row(k).transpose() / size_;
    x_[k] = local.x();
    y_[k] = local.y();
    z_[k] = degree > 2 ? local.z() : height_as_on_sphere(local.x(), local.y(), local.z());
  }
  return (degree == 1 ? determine_second_order(patch) : determine(patch, degree)) &&
    slope_.allFinite();
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
  slope_ << c[0], c[1], 2 * c[2] / size_, c[3] / size_, 2 * c[4] / size_;
  residual_ = size_ * equations_.residual() / as_vector(patch.weight).norm();
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
  const Vector3 c = second_order_ * z;
  slope_ << 0, 0, 2 * c[0] / size_, c[1] / size_, 2 * c[2] / size_;
  residual_ = size_ * (weight.asDiagonal() * z - A * (inverse * z)).norm() / weight.norm();
  return second_order_.allFinite();
}

Vector3 HeightFit::normal() const
{
  return frame_.transpose() * Vector3(-slope_[0], -slope_[1], 1).normalized();
}

namespace
{

/// Of a height z(x, y): g the determinant of the metric, g^{ab} its inverse.
struct Metric
{
  Metric(double zx, double zy)
    : g(1 + zx * zx + zy * zy), xx((1 + zy * zy) / g), xy(-zx * zy / g), yy((1 + zx * zx) / g)
  {
  }
  double g, xx, xy, yy;
};

/// g^{ab} z_ab
double turn(const Metric& metric, const Eigen::Vector<double, 5>& slope)
{
  return metric.xx * slope[2] + 2 * metric.xy * slope[3] + metric.yy * slope[4];
}

}

// Monge patch: H = −½ g^{ab} z_ab/√g, K = det z_ab/g².
double HeightFit::mean() const
{
  const Metric metric(slope_[0], slope_[1]);
  return -0.5 * turn(metric, slope_) / std::sqrt(metric.g);
}

double HeightFit::gauss() const
{
  const double g = Metric(slope_[0], slope_[1]).g;
  return (slope_[2] * slope_[4] - slope_[3] * slope_[3]) / (g * g);
}

// Δ_s f = (1/√g) ∂_a(√g g^{ab} ∂_b f) = g^{ab} (f_ab − z_ab ∇z·∇f/g), exact for the polynomials.
std::span<const double> HeightFit::laplacian(const Patch& patch)
{
  const Metric metric(slope_[0], slope_[1]);
  const double along = -turn(metric, slope_) / metric.g;
  const double square = size_ * size_;
  const Vector3 second(2 * metric.xx / square, 2 * metric.xy / square, 2 * metric.yy / square);
  laplacian_.resize(patch.count());
  if (degree_ == 1)
  {
    Eigen::Map<Eigen::VectorXd>(laplacian_.data(), patch.count()) =
      second_order_.transpose() * second;
    return laplacian_;
  }
  functional_.assign(unknowns(degree_), 0);
  functional_[0] = along * slope_[0] / size_;
  functional_[1] = along * slope_[1] / size_;
  std::copy_n(second.data(), 3, functional_.begin() + 2);
  const auto row = equations_.functional(functional_);
  std::transform(
    row.begin(), row.end(), patch.weight.begin(), laplacian_.begin(), std::multiplies<>());
  return laplacian_;
}

}
