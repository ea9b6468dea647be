#include "solver/equilibrium/Meridian.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace vesicle
{

namespace
{

using std::numbers::pi;

constexpr int degree = 5, width = degree + 1;
// Of the unevenness beside the energy: any weight has the same solution.
constexpr double evenness_weight = 0.1;
// The distance to the axis, in r0, below which the speed no longer falls.
constexpr double pole = 0.03;

// Gauss–Legendre on [0, 1]; degree 7, which the tests' convergence is limited by no more than by
// the splines.
constexpr int gauss_points = 4;
constexpr std::array<double, gauss_points> gauss_node{ 0.0694318442029737, 0.3300094782075719,
  0.6699905217924281, 0.9305681557970263 };
constexpr std::array<double, gauss_points> gauss_weight{ 0.1739274225687269, 0.3260725774312731,
  0.3260725774312731, 0.1739274225687269 };

/// The splines of an interval at u in [0, 1], and their derivatives in u: the k-th begins k − degree
/// knots from the interval's.
struct Splines
{
  std::array<std::array<double, width>, 3> order{};

  explicit Splines(double u)
  {
    std::array<std::array<double, width + 2>, width> N{}; // of each degree, shifted by one
    N[0][1] = 1;
    for (int p = 1; p <= degree; ++p)
      for (int i = 0; i <= p; ++i)
        N[p][i + 1] = ((u + p - i) * N[p - 1][i] + (i + 1 - u) * N[p - 1][i + 1]) / p;
    for (int i = 0; i < width; ++i)
    {
      order[0][i] = N[degree][i + 1];
      order[1][i] = N[degree - 1][i] - N[degree - 1][i + 1];
      order[2][i] =
        (i > 0 ? N[degree - 2][i - 1] : 0) - 2 * N[degree - 2][i] + N[degree - 2][i + 1];
    }
  }
};

/// A value with its first and second derivatives in r, r′, r″, z′ and z″.
struct Jet
{
  using Vector = Eigen::Matrix<double, 5, 1>;
  using Matrix = Eigen::Matrix<double, 5, 5>;
  double value = 0;
  Vector first = Vector::Zero();
  Matrix second = Matrix::Zero();

  static Jet variable(double value, int which)
  {
    Jet jet{ value };
    jet.first[which] = 1;
    return jet;
  }
  friend Jet operator+(const Jet& a, const Jet& b)
  {
    return { a.value + b.value, a.first + b.first, a.second + b.second };
  }
  friend Jet operator-(const Jet& a, const Jet& b) { return a + -1 * b; }
  friend Jet operator*(double s, const Jet& a)
  {
    return { s * a.value, s * a.first, s * a.second };
  }
  friend Jet operator*(const Jet& a, const Jet& b)
  {
    const Matrix cross = a.first * b.first.transpose();
    return { a.value * b.value, a.value * b.first + b.value * a.first,
      a.value * b.second + b.value * a.second + cross + cross.transpose() };
  }
  friend Jet pow(const Jet& a, double exponent)
  {
    const double p = std::pow(a.value, exponent), d = exponent * p / a.value,
                 dd = (exponent - 1) * d / a.value;
    return { p, d * a.first, d * a.second + dd * (a.first * a.first.transpose()) };
  }
};

/// A coefficient of the continued series: where it is stored, and its sign; nowhere: it is 0.
struct Place
{
  int index;
  double sign;
};

Place place_of_r(int j, int n)
{
  double sign = 1;
  if (j < 0 || j > n)
  {
    j = j < 0 ? -j : 2 * n - j;
    sign = -1;
  }
  return j == 0 || j == n ? Place{ -1, 0 } : Place{ j - 1, sign };
}

Place place_of_z(int j, int n)
{
  return { n - 1 + (j < 0 ? -j : j > n ? 2 * n - j : j), 1 };
}

/// The relative speed at a distance r from the axis is 1/√stretch.
template<class Number>
Number stretch(const Number& r)
{
  using std::pow;
  return Number{ 1 } + pow(r * r + Number{ pole * pole }, -1.);
}

/// What is integrated over t, at one quadrature point, by the coefficients of its interval.
struct Densities
{
  double weight;
  std::array<int, 2 * width> index; ///< of the coefficients
  Eigen::Matrix<double, 5, 2 * width> of_coefficients;
  Jet energy, area, volume, even_speed, uneven;

  void add_first(Eigen::VectorXd& sum, const Jet& jet) const
  {
    const Eigen::Matrix<double, 2 * width, 1> part =
      weight * (of_coefficients.transpose() * jet.first);
    for (int k = 0; k < 2 * width; ++k)
      if (index[k] >= 0)
        sum[index[k]] += part[k];
  }
  void add_second(Eigen::MatrixXd& sum, const Jet::Matrix& second) const
  {
    const Eigen::Matrix<double, 2 * width, 2 * width> part =
      weight * (of_coefficients.transpose() * second * of_coefficients);
    for (int k = 0; k < 2 * width; ++k)
      for (int l = 0; l < 2 * width; ++l)
        if (index[k] >= 0 && index[l] >= 0)
          sum(index[k], index[l]) += part(k, l);
  }
};

// U = weight · ∫ (σ − mean σ)² dt with σ² = stretch · (r′² + z′²); its first derivatives are those of
// ∫ (σ² − 2 mean σ) dt with the mean held, its second ones too but for a part of rank one.
// Calls visit(densities) at every quadrature point.
template<class Visit>
void for_each_point(const Meridian& meridian, double mean, Visit visit)
{
  const int intervals = meridian.intervals();
  const Eigen::VectorXd& coefficients = meridian.coefficients();
  const double per_t = intervals / pi;
  Densities d;
  for (int q = 0; q < gauss_points; ++q)
  {
    const Splines splines(gauss_node[q]);
    d.weight = gauss_weight[q] * pi / intervals;
    for (int i = 0; i < intervals; ++i)
    {
      d.of_coefficients.setZero();
      Jet::Vector u = Jet::Vector::Zero();
      for (int k = 0; k < width; ++k)
      {
        const int j = i - degree / 2 + k;
        const Place of_r = place_of_r(j, intervals), of_z = place_of_z(j, intervals);
        const Eigen::Vector3d by(
          splines.order[0][k], per_t * splines.order[1][k], per_t * per_t * splines.order[2][k]);
        d.index[2 * k] = of_r.index;
        d.index[2 * k + 1] = of_z.index;
        d.of_coefficients.col(2 * k).head<3>() = of_r.sign * by;
        d.of_coefficients.col(2 * k + 1).tail<2>() = by.tail<2>();
      }
      for (int k = 0; k < 2 * width; ++k)
        if (d.index[k] >= 0)
          u += d.of_coefficients.col(k) * coefficients[d.index[k]];
      const Jet r = Jet::variable(u[0], 0), r1 = Jet::variable(u[1], 1),
                r2 = Jet::variable(u[2], 2), z1 = Jet::variable(u[3], 3),
                z2 = Jet::variable(u[4], 4);
      const Jet squared = r1 * r1 + z1 * z1, speed = pow(squared, 0.5),
                curved = r * (z1 * r2 - r1 * z2) - z1 * squared, // 2H r speed³
        stretched = stretch(r);
      d.energy = pi * (curved * curved * pow(r, -1) * pow(squared, -2.5));
      d.area = 2 * pi * (r * speed);
      d.volume = -pi * (r * r * z1);
      d.even_speed = speed * pow(stretched, 0.5);
      d.uneven = evenness_weight * (squared * stretched - 2 * mean * d.even_speed);
      visit(d);
    }
  }
}

}

double Meridian::Point::speed() const
{
  return std::hypot(r1, z1);
}

std::array<double, 2> Meridian::Point::curvatures() const
{
  const double s = speed(), along = (z1 * r2 - r1 * z2) / (s * s * s);
  constexpr double axis = 1e-9; // umbilic there
  return { along, r > axis ? -z1 / (r * s) : along };
}

Meridian::Meridian(int intervals, const Curve& curve) : intervals_(intervals)
{
  const int n = intervals, fine = 40 * n;
  std::vector<double> way{ 0 };
  Eigen::Vector2d last = curve(0);
  for (int i = 1; i <= fine; ++i)
  {
    const Eigen::Vector2d next = curve(i * pi / fine);
    way.push_back(way.back() + (next - last).norm() * std::sqrt(stretch((next[0] + last[0]) / 2)));
    last = next;
  }
  Eigen::MatrixXd at_knots = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  Eigen::VectorXd values(2 * n);
  const Splines splines(0);
  for (int knot = 0; knot <= n; ++knot)
  {
    const double wanted = way.back() * knot / n;
    const auto i = std::clamp<std::ptrdiff_t>(
      std::lower_bound(way.begin(), way.end(), wanted) - way.begin(), 1, fine);
    const double part = (wanted - way[i - 1]) / (way[i] - way[i - 1]);
    const Eigen::Vector2d p = curve((static_cast<double>(i) - 1 + part) * pi / fine);
    for (int k = 0; k < width; ++k)
    {
      const Place of_r = place_of_r(knot - degree / 2 + k, n),
                  of_z = place_of_z(knot - degree / 2 + k, n);
      at_knots(n - 1 + knot, of_z.index) += splines.order[0][k];
      if (knot > 0 && knot < n && of_r.index >= 0)
        at_knots(knot - 1, of_r.index) += of_r.sign * splines.order[0][k];
    }
    values[n - 1 + knot] = p[1];
    if (knot > 0 && knot < n)
      values[knot - 1] = p[0];
  }
  coefficients_ = at_knots.partialPivLu().solve(values);
}

Meridian::Point Meridian::at(double t) const
{
  const double per_t = intervals_ / pi;
  const int interval = std::clamp(static_cast<int>(t * per_t), 0, intervals_ - 1);
  const Splines splines(t * per_t - interval);
  std::array<std::array<double, 3>, 2> sum{};
  for (int k = 0; k < width; ++k)
  {
    const int j = interval - degree / 2 + k;
    const Place of_r = place_of_r(j, intervals_), of_z = place_of_z(j, intervals_);
    const double r = of_r.index < 0 ? 0 : of_r.sign * coefficients_[of_r.index],
                 z = coefficients_[of_z.index];
    for (int d = 0; d < 3; ++d)
    {
      sum[0][d] += splines.order[d][k] * r;
      sum[1][d] += splines.order[d][k] * z;
    }
  }
  return { sum[0][0], per_t * sum[0][1], per_t * per_t * sum[0][2], sum[1][0], per_t * sum[1][1],
    per_t * per_t * sum[1][2] };
}

double Meridian::mean_speed() const
{
  double sum = 0;
  for (int i = 0; i < intervals_; ++i)
    for (int q = 0; q < gauss_points; ++q)
    {
      const Point p = at((i + gauss_node[q]) * pi / intervals_);
      sum += gauss_weight[q] / intervals_ * p.speed() * std::sqrt(stretch(p.r));
    }
  return sum;
}

Meridian::Derivatives Meridian::derivatives() const
{
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(coefficients_.size());
  Derivatives s{ measures(), zero, zero, zero, zero };
  for_each_point(*this, mean_speed(),
    [&](const Densities& d)
    {
      d.add_first(s.energy, d.energy);
      d.add_first(s.area, d.area);
      d.add_first(s.volume, d.volume);
      d.add_first(s.unevenness, d.uneven);
    });
  return s;
}

Eigen::MatrixXd Meridian::second_derivatives(double tension, double pressure) const
{
  const Eigen::Index n = coefficients_.size();
  Eigen::MatrixXd second = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd length = Eigen::VectorXd::Zero(n);
  for_each_point(*this, mean_speed(),
    [&](const Densities& d)
    {
      d.add_second(second,
        d.energy.second + tension * d.area.second - pressure * d.volume.second + d.uneven.second);
      d.add_first(length, d.even_speed);
    });
  return second - 2 * evenness_weight / pi * length * length.transpose();
}

Meridian::Measures Meridian::measures() const
{
  Measures m;
  const double mean = mean_speed();
  for (int i = 0; i < intervals_; ++i)
    for (int q = 0; q < gauss_points; ++q)
    {
      const Point p = at((i + gauss_node[q]) * pi / intervals_);
      const double weight = gauss_weight[q] * pi / intervals_, speed = p.speed();
      const auto [along, across] = p.curvatures();
      m.energy += weight * pi * p.r * speed * (along + across) * (along + across);
      m.area += weight * 2 * pi * p.r * speed;
      m.volume -= weight * pi * p.r * p.r * p.z1;
      m.unevenness +=
        weight * evenness_weight * std::pow(speed * std::sqrt(stretch(p.r)) - mean, 2);
    }
  return m;
}

}
