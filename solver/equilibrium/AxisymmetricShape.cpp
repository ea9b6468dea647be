#include "solver/equilibrium/AxisymmetricShape.h"

#include "solver/Errors.h"
#include "solver/mesh/shapes/Bowl.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vesicle
{

namespace
{

using std::numbers::pi;

constexpr int intervals = 60;
constexpr double unit_volume = 4 * pi / 3;
constexpr double farthest = 0.3; // of a coefficient in a step, in r0

double area_of(double reduced_volume)
{
  return 4 * pi * std::pow(reduced_volume, -2. / 3);
}

/// Levenberg's method: Newton's, damped where it doesn't lead downhill.
class MeridianSearch
{
public:
  /// Among the surfaces that a basis of coefficients spans.
  MeridianSearch(Meridian start, double area, const Eigen::MatrixXd& basis)
    : area_(area), meridian_(std::move(start)), basis_(basis)
  {
  }

  /// False if there is no shape within that many steps.
  bool run(int most_steps);
  AxisymmetricShape shape() const
  {
    return { meridian_, meridian_.measures().energy, multipliers_ };
  }

private:
  struct Off
  {
    double area, volume;
  };
  Off off(const Meridian::Measures& m) const { return { m.area - area_, m.volume - unit_volume }; }
  /// Two yardsticks: the first sees constraints that are off, the second lets Newton's method have
  /// its way at the end.
  double penalised(const Meridian::Measures& m) const;
  double lagrangian(const Meridian::Measures& m) const;
  bool improves(const Meridian& trial, const Meridian::Measures& now) const;
  void step(const Meridian::Measures& now, const Eigen::MatrixXd& constraints,
    const Eigen::VectorXd& gradient, const Eigen::MatrixXd& second);

  double area_;
  Meridian meridian_;
  const Eigen::MatrixXd& basis_;
  Multipliers multipliers_;
  double damping_ = 1e-3;
};

double MeridianSearch::penalised(const Meridian::Measures& m) const
{
  const double price =
    20 + 2 * std::max(std::abs(multipliers_.tension), std::abs(multipliers_.pressure));
  return m.energy + m.unevenness + price * (std::abs(off(m).area) + std::abs(off(m).volume));
}

double MeridianSearch::lagrangian(const Meridian::Measures& m) const
{
  const Off by = off(m);
  constexpr double penalty = 20;
  return m.energy + m.unevenness + multipliers_.tension * by.area -
    multipliers_.pressure * by.volume + penalty * (by.area * by.area + by.volume * by.volume);
}

bool MeridianSearch::improves(const Meridian& trial, const Meridian::Measures& now) const
{
  constexpr double rounding = 1e-9;
  const Meridian::Measures then = trial.measures();
  // Splines that cross the axis have energies below a sphere's, or none.
  if (!(then.energy > 0.9 * 8 * pi) || !(then.volume > 0))
    return false;
  return penalised(then) < penalised(now) + rounding ||
    lagrangian(then) < lagrangian(now) + rounding;
}

void MeridianSearch::step(const Meridian::Measures& now, const Eigen::MatrixXd& constraints,
  const Eigen::VectorXd& gradient, const Eigen::MatrixXd& second)
{
  const Eigen::Index n = constraints.rows(), m = constraints.cols();
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(constraints);
  const Eigen::MatrixXd Q = qr.householderQ(), free = Q.rightCols(n - m);
  const Eigen::MatrixXd R = qr.matrixQR().topRows(m).triangularView<Eigen::Upper>();
  const Off by = off(now);
  const Eigen::Vector2d wanted(-by.area, -by.volume);
  const Eigen::VectorXd feasible =
    Q.leftCols(m) * R.transpose().triangularView<Eigen::Lower>().solve(wanted).eval();
  const Eigen::MatrixXd H = free.transpose() * second * free;
  const Eigen::VectorXd g = free.transpose() * (gradient + second * feasible);
  constexpr double least_damping = 1e-6, most_damping = 1e12;
  for (; damping_ < most_damping; damping_ = std::max(1e-3, 4 * damping_))
  {
    const Eigen::LLT<Eigen::MatrixXd> factors(
      H + damping_ * Eigen::MatrixXd::Identity(n - m, n - m));
    if (factors.info() != Eigen::Success)
      continue;
    Eigen::VectorXd displacement = basis_ * (feasible - free * factors.solve(g));
    const double largest = displacement.cwiseAbs().maxCoeff();
    if (largest > farthest)
    {
      if (feasible.cwiseAbs().maxCoeff() < farthest / 3)
        continue;
      displacement *= farthest / largest;
    }
    Meridian trial = meridian_;
    trial.move(displacement);
    if (!improves(trial, now))
      continue;
    meridian_ = std::move(trial);
    damping_ = damping_ < least_damping ? 0 : damping_ / 5;
    return;
  }
}

bool MeridianSearch::run(int most_steps)
{
  constexpr double at_rest = 1e-6, kept = 1e-9;
  for (int k = 0; k < most_steps && damping_ < 1e12; ++k)
  {
    const Meridian::Derivatives first = meridian_.derivatives();
    Eigen::MatrixXd constraints(basis_.cols(), 2);
    constraints << basis_.transpose() * first.area, basis_.transpose() * first.volume;
    const Eigen::VectorXd gradient = basis_.transpose() * (first.energy + first.unevenness);
    const Eigen::Vector2d x = constraints.colPivHouseholderQr().solve(-gradient);
    multipliers_ = { x[0], -x[1] };
    const Off by = off(first.value);
    if ((gradient + constraints * x).norm() < at_rest &&
      std::abs(by.area) + std::abs(by.volume) < kept)
      return true;
    const Eigen::MatrixXd second =
      meridian_.second_derivatives(multipliers_.tension, multipliers_.pressure);
    step(first.value, constraints, gradient, basis_.transpose() * second * basis_);
  }
  return false;
}

Meridian of_unit_volume(Meridian meridian)
{
  meridian.scale(std::cbrt(unit_volume / meridian.measures().volume));
  return meridian;
}

/// A sphere with an amplitude of Y20, of about that reduced volume.
Meridian near_sphere(double sign, double reduced_volume)
{
  const double amplitude = sign * 1.1 * std::sqrt(1 - reduced_volume);
  return of_unit_volume(Meridian(intervals,
    [&](double t) -> Eigen::Vector2d
    {
      const double r = 1 + amplitude * (1.5 * std::cos(t) * std::cos(t) - 0.5);
      return { r * std::sin(t), r * std::cos(t) };
    }));
}

Meridian bowl(double half_thickness)
{
  return of_unit_volume(
    Meridian(intervals, [&](double t) { return bowl_meridian(half_thickness, 1 - t / pi); }));
}

/// Coefficients of surfaces that are the same upside down, or, for stomatocytes, of all whose mean
/// height is 0.
Eigen::MatrixXd basis_of(EquilibriumBranch branch)
{
  constexpr int n = intervals, size = 2 * n;
  std::vector<Eigen::VectorXd> columns;
  const auto add = [&](int i, int j, double at_j)
  {
    Eigen::VectorXd column = Eigen::VectorXd::Zero(size);
    column[i] += 1;
    column[j] += at_j;
    if (column.norm() > 0)
      columns.push_back(column.normalized());
  };
  const bool symmetric = branch != EquilibriumBranch::stomatocyte;
  // r_1 … r_{n−1} are the entries 0 … n − 2, z_0 … z_n those after them.
  for (int i = 0; i < n - 1; ++i)
  {
    if (!symmetric)
      columns.emplace_back(Eigen::VectorXd::Unit(size, i));
    else if (i <= n - 2 - i)
      add(i, n - 2 - i, 1);
  }
  for (int i = 0; i <= n; ++i)
  {
    if (symmetric ? i < n - i : i < n)
      add(n - 1 + i, symmetric ? size - 1 - i : n + i, -1);
  }
  Eigen::MatrixXd basis(size, columns.size());
  for (std::size_t k = 0; k < columns.size(); ++k)
    basis.col(static_cast<Eigen::Index>(k)) = columns[k];
  return basis;
}

struct Origin
{
  Meridian meridian;
  double reduced_volume;
};

/// A shape of the branch that is easily found, as near as may be.
Origin origin_of(EquilibriumBranch branch, double reduced_volume)
{
  constexpr double round = 0.95, of_bowl = 0.5;
  if (branch == EquilibriumBranch::stomatocyte)
    return { bowl(of_bowl / 2), of_bowl };
  const double v = std::max(reduced_volume, round);
  return { near_sphere(branch == EquilibriumBranch::prolate ? 1 : -1, v), v };
}

[[noreturn]] void refuse(EquilibriumBranch branch, double wanted, double reached)
{
  throw InputError(fmt::format("reduced_volume = {}: the {} branch was followed to {:.4f} and no "
                               "farther: choose a reduced volume on this side of it",
    wanted, branch_name(branch), reached));
}

}

EquilibriumBranch equilibrium_branch(const std::string& name)
{
  std::string known;
  for (const EquilibriumBranch branch : equilibrium_branches())
  {
    if (branch_name(branch) == name)
      return branch;
    known += " ";
    known += branch_name(branch);
  }
  throw InputError(fmt::format("branch '{}' isn't known; there are:{}", name, known));
}

std::string branch_name(EquilibriumBranch branch)
{
  return branch == EquilibriumBranch::prolate ? "prolate"
    : branch == EquilibriumBranch::oblate     ? "oblate"
                                              : "stomatocyte";
}

std::vector<EquilibriumBranch> equilibrium_branches()
{
  return { EquilibriumBranch::prolate, EquilibriumBranch::oblate, EquilibriumBranch::stomatocyte };
}

AxisymmetricShape axisymmetric_equilibrium(EquilibriumBranch branch, double reduced_volume)
{
  constexpr int most_first_steps = 100, most_steps = 20;
  constexpr double longest = 0.1, shortest = 1e-3; // of the way from one shape to the next
  if (!(reduced_volume > 0 && reduced_volume < 1))
    throw InputError(
      fmt::format("reduced_volume = {}: that of an equilibrium is above 0 and below 1, a sphere's",
        reduced_volume));
  const Origin origin = origin_of(branch, reduced_volume);
  const Eigen::MatrixXd basis = basis_of(branch);
  MeridianSearch first(origin.meridian, area_of(origin.reduced_volume), basis);
  if (!first.run(most_first_steps))
    refuse(branch, reduced_volume, origin.reduced_volume);
  AxisymmetricShape shape = first.shape();
  double v = origin.reduced_volume, stride = longest;
  while (v != reduced_volume)
  {
    const double left = reduced_volume - v,
                 next = std::abs(left) <= stride ? reduced_volume : v + std::copysign(stride, left);
    MeridianSearch search(shape.meridian, area_of(next), basis);
    if (search.run(most_steps))
    {
      shape = search.shape();
      v = next;
    }
    else if ((stride /= 2) < shortest)
      refuse(branch, reduced_volume, v);
  }
  return shape;
}

}
