#include "tests/solver/support/ReferenceProfile.h"

#include "tests/solver/support/TestMeshes.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <numbers>
#include <sstream>
#include <stdexcept>

namespace vesicle::test
{

namespace
{

using Eigen::VectorXd;

/// The cubic spline through (x, y) whose first (even) or second (odd) derivative vanishes at both
/// ends.
class Spline
{
public:
  Spline(const std::vector<double>& x, const std::vector<double>& y, bool even) : x_(x), y_(y)
  {
    const int n = static_cast<int>(x.size());
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
    VectorXd b = VectorXd::Zero(n);
    for (int i = 0; i < n; ++i)
    {
      const bool end = i == 0 || i == n - 1;
      if (end && !even)
      {
        A(i, i) = 1;
        continue;
      }
      for (const int j : { i - 1, i + 1 })
      {
        if (j < 0 || j == n)
          continue;
        const double h = std::abs(x[j] - x[i]);
        A(i, i) += h / 3;
        A(i, j) += h / 6;
        b[i] += (y[j] - y[i]) / h;
      }
    }
    second_ = A.partialPivLu().solve(b);
  }

  double operator()(double x) const
  {
    const auto above = std::upper_bound(x_.begin() + 1, x_.end() - 1, x);
    const std::size_t i = above - x_.begin(), j = i - 1;
    const double h = x_[i] - x_[j], a = (x_[i] - x) / h, b = 1 - a;
    return a * y_[j] + b * y_[i] +
      ((a * a * a - a) * second_[j] + (b * b * b - b) * second_[i]) * h * h / 6;
  }

private:
  std::vector<double> x_, y_;
  VectorXd second_;
};

}

SphericalParametrisation reference_profile(const std::string& name)
{
  const auto columns = read_reference("profiles/" + name + ".csv");
  const std::vector<double>& s = columns.at("s");
  const auto r = std::make_shared<const Spline>(s, columns.at("r"), false);
  const auto z = std::make_shared<const Spline>(s, columns.at("z"), true);
  return [r, z, length = s.back()](const Vector3& d) -> Vector3
  {
    const double across = std::hypot(d.x(), d.y());
    const double way = std::atan2(across, d.z()) / std::numbers::pi * length;
    const double scale = across > 0 ? (*r)(way) / across : 0;
    return { scale * d.x(), scale * d.y(), (*z)(way) };
  };
}

double reference_energy(const std::string& branch, double reduced_volume)
{
  std::ifstream file(VESICLE_SOURCE_DIR "/data/reference/equilibria.csv");
  for (std::string line; std::getline(file, line);)
  {
    std::stringstream cells(line);
    std::string name, v, energy;
    std::getline(cells, name, ',');
    std::getline(cells, v, ',');
    std::getline(cells, energy, ',');
    if (name == branch && std::stod(v) == reduced_volume)
      return std::stod(energy);
  }
  throw std::runtime_error("no such equilibrium: " + branch);
}

}
