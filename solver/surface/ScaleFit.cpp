#include "solver/surface/ScaleFit.h"

#include "solver/Multiversion.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vesicle
{

namespace
{

using Vector6 = Eigen::Vector<double, 6>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

// Terms that the points, within a radius of 1, don't tell apart.
constexpr double least_pivot = 1e-9;

/// Sums over the points: of the products of the terms 1, u, v, u², uv, v², of these times the
/// heights, of the heights squared.
struct Sums
{
  double one, u, v, uu, uv, vv, uuu, uuv, uvv, vvv, uuuu, uuuv, uuvv, uvvv, vvvv;
  double h, hu, hv, huu, huv, hvv, hh;
};

VESICLE_MULTIVERSION
void add_up(int n, const double* u, const double* v, const double* h, Sums& sums)
{
  double s_u = 0, s_v = 0, s_uu = 0, s_uv = 0, s_vv = 0, s_uuu = 0, s_uuv = 0, s_uvv = 0, s_vvv = 0,
         s_uuuu = 0, s_uuuv = 0, s_uuvv = 0, s_uvvv = 0, s_vvvv = 0;
  double s_h = 0, s_hu = 0, s_hv = 0, s_huu = 0, s_huv = 0, s_hvv = 0, s_hh = 0;
#pragma omp simd reduction(+ : s_u, s_v, s_uu, s_uv, s_vv, s_uuu, s_uuv, s_uvv, s_vvv, s_uuuu)         \
  reduction(+ : s_uuuv, s_uuvv, s_uvvv, s_vvvv, s_h, s_hu, s_hv, s_huu, s_huv, s_hvv, s_hh)
  for (int i = 0; i < n; ++i)
  {
    const double uu = u[i] * u[i], uv = u[i] * v[i], vv = v[i] * v[i];
    s_u += u[i];
    s_v += v[i];
    s_uu += uu;
    s_uv += uv;
    s_vv += vv;
    s_uuu += uu * u[i];
    s_uuv += uu * v[i];
    s_uvv += vv * u[i];
    s_vvv += vv * v[i];
    s_uuuu += uu * uu;
    s_uuuv += uu * uv;
    s_uuvv += uu * vv;
    s_uvvv += uv * vv;
    s_vvvv += vv * vv;
    s_h += h[i];
    s_hu += h[i] * u[i];
    s_hv += h[i] * v[i];
    s_huu += h[i] * uu;
    s_huv += h[i] * uv;
    s_hvv += h[i] * vv;
    s_hh += h[i] * h[i];
  }
  sums = { static_cast<double>(n), s_u, s_v, s_uu, s_uv, s_vv, s_uuu, s_uuv, s_uvv, s_vvv, s_uuuu,
    s_uuuv, s_uuvv, s_uvvv, s_vvvv, s_h, s_hu, s_hv, s_huu, s_huv, s_hvv, s_hh };
}

/// to = start + (x, y, z) · axis
VESICLE_MULTIVERSION
void project(int n, const double* x, const double* y, const double* z,
  const Eigen::RowVector3d& axis, double start, double* to)
{
  const double a = axis[0], b = axis[1], c = axis[2];
#pragma omp simd
  for (int i = 0; i < n; ++i)
    to[i] = start + a * x[i] + b * y[i] + c * z[i];
}

/// Heights w become w (1 − |∇w|²/4): |∇w|² = (κ² + τ²) r² in a direction of normal curvature κ and
/// geodesic torsion τ, with κ r² = 2 w and, of shape operator S, τ r² = S x · Jx, J a quarter turn.
VESICLE_MULTIVERSION
void straighten(int n, const double* u, const double* v, const Eigen::Matrix2d& S, double* w)
{
  constexpr double tiny = 1e-300; // the origin itself
  const double skew = S(1, 1) - S(0, 0), mixed = S(0, 1);
#pragma omp simd
  for (int i = 0; i < n; ++i)
  {
    const double along = u[i] * u[i] + v[i] * v[i];
    const double torsion = mixed * (u[i] * u[i] - v[i] * v[i]) + skew * u[i] * v[i];
    w[i] *= along / (along + w[i] * w[i] + 0.25 * torsion * torsion + tiny);
  }
}

Eigen::Vector<double, 5> slopes(const Vector6& c, double radius)
{
  return { c[1], c[2], 2 * c[3] / radius, c[4] / radius, 2 * c[5] / radius };
}

/// A foot that was c0 too low has made w + c0 (1 − 3 w²/r²) of the heights w.
Vector6 corrected(Vector6 c)
{
  Eigen::Matrix2d second;
  second << c[3], c[4] / 2, c[4] / 2, c[5];
  second += 3 * c[0] * second * second;
  c.tail<3>() << second(0, 0), 2 * second(0, 1), second(1, 1);
  return c;
}

Matrix6 matrix_of(const Sums& s)
{
  Matrix6 N;
  N << s.one, s.u, s.v, s.uu, s.uv, s.vv,       //
    s.u, s.uu, s.uv, s.uuu, s.uuv, s.uvv,       //
    s.v, s.uv, s.vv, s.uuv, s.uvv, s.vvv,       //
    s.uu, s.uuu, s.uuv, s.uuuu, s.uuuv, s.uuvv, //
    s.uv, s.uuv, s.uvv, s.uuuv, s.uuvv, s.uvvv, //
    s.vv, s.uvv, s.vvv, s.uuvv, s.uvvv, s.vvvv;
  return N;
}

}

int ScaleFit::choose(const Candidates& from, const Vector3& vertex, const Vector3& normal,
  double radius, double least_cosine)
{
  const int n = static_cast<int>(from.x.size());
  x_.resize(n);
  y_.resize(n);
  z_.resize(n);
  chosen_.resize(n);
  int count = 0;
  for (int i = 0; i < n; ++i) // without a branch that nothing would foresee
  {
    const double x = from.x[i] - vertex.x(), y = from.y[i] - vertex.y(), z = from.z[i] - vertex.z();
    const double cosine =
      from.nx[i] * normal.x() + from.ny[i] * normal.y() + from.nz[i] * normal.z();
    x_[count] = x;
    y_[count] = y;
    z_[count] = z;
    chosen_[count] = i;
    count += int(x * x + y * y + z * z <= radius * radius) & int(cosine >= least_cosine);
  }
  x_.resize(count);
  y_.resize(count);
  z_.resize(count);
  chosen_.resize(count);
  return count;
}

void ScaleFit::see_from(const Eigen::Matrix3d& frame, const Vector3& origin, double radius)
{
  const int n = count();
  u_.resize(n);
  v_.resize(n);
  w_.resize(n);
  const Eigen::Matrix3d axes = frame / radius;
  const Vector3 start = -axes * origin;
  for (const auto& [axis, to] : { std::pair(0, &u_), { 1, &v_ }, { 2, &w_ } })
    project(n, x_.data(), y_.data(), z_.data(), axes.row(axis), start[axis], to->data());
}

bool ScaleFit::fit(std::span<const double> heights)
{
  Sums sums;
  add_up(count(), u_.data(), v_.data(), heights.data(), sums);
  const Eigen::LDLT<Matrix6> N(matrix_of(sums));
  const auto pivots = N.vectorD();
  if (count() <= 6 || !(pivots.minCoeff() > least_pivot * pivots.maxCoeff()))
    return false;
  const Vector6 moments(sums.h, sums.hu, sums.hv, sums.huu, sums.huv, sums.hvv);
  coefficients_ = N.solve(moments);
  misfit_ = std::max(0., sums.hh - coefficients_.dot(moments)) / count();
  const Vector6 mean(0, 0, 0, 1, 0, 1);
  mean_variance_ = mean.dot(N.solve(mean));
  return coefficients_.allFinite();
}

bool ScaleFit::compute(const Vector3& normal, double radius)
{
  surface_.frame = frame_along(normal);
  see_from(surface_.frame, Vector3::Zero(), radius);
  if (!fit(w_))
    return false;
  surface_.slope = slopes(coefficients_, radius);
  const Vector3 tilted = surface_.normal();
  const Vector3 foot = radius * coefficients_[0] * normal.dot(tilted) * tilted;
  const Eigen::Matrix3d curved = surface_.shape();
  surface_.frame = frame_along(tilted);
  see_from(surface_.frame, foot, radius);
  const Eigen::Matrix2d S =
    radius * (surface_.frame * curved * surface_.frame.transpose()).topLeftCorner<2, 2>();
  straighten(count(), u_.data(), v_.data(), S, w_.data());
  if (!fit(w_))
    return false;
  surface_.slope = slopes(corrected(coefficients_), radius);
  residual_ = radius * std::sqrt(misfit_);
  mean_error_ = std::sqrt(misfit_ * count() / (count() - 6) * mean_variance_) / radius;
  return surface_.slope.allFinite();
}

// Over the tangent plane the metric is that of the plane, to first order.
double ScaleFit::laplacian(const Vector3& normal, double radius, std::span<const double> field)
{
  see_from(frame_along(normal), Vector3::Zero(), radius);
  return fit(field) ? 2 * (coefficients_[3] + coefficients_[5]) / (radius * radius) : 0;
}

}
