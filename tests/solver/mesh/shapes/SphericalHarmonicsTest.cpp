#include "solver/Errors.h"
#include "solver/mesh/shapes/SphericalHarmonics.h"
#include "tests/solver/support/SmallMeshes.h"

#include <gtest/gtest.h>

namespace vesicle::test
{

namespace
{
struct Node
{
  Vector3 direction;
  double weight;
};

/// Gauss–Legendre in cos θ times the trapezoidal rule in φ: exact to degree 2 n − 1.
std::vector<Node> sphere_quadrature(int n)
{
  std::vector<Node> nodes;
  for (int i = 0; i < n; ++i)
  {
    double z = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
    double slope = 1;
    for (int newton = 0; newton < 50; ++newton)
    {
      const double value = std::legendre(n, z);
      slope = n * (z * value - std::legendre(n - 1, z)) / (z * z - 1);
      z -= value / slope;
    }
    const double weight = 2 / ((1 - z * z) * slope * slope);
    for (int j = 0; j < 2 * n; ++j)
    {
      const double phi = std::numbers::pi * (j + 0.3) / n;
      const double rho = std::sqrt(1 - z * z);
      nodes.push_back(
        { { rho * std::cos(phi), rho * std::sin(phi), z }, weight * std::numbers::pi / n });
    }
  }
  return nodes;
}
}

TEST(SphericalHarmonics, AreOrthonormal)
{
  const int degree = 6;
  const std::vector<Node> nodes = sphere_quadrature(degree + 2);
  const int count = (degree + 1) * (degree + 1);
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(count, count);
  for (const auto& [direction, weight] : nodes)
  {
    Eigen::VectorXd values(count);
    for (int l = 0, k = 0; l <= degree; ++l)
      for (int m = -l; m <= l; ++m)
        values[k++] = real_spherical_harmonic(l, m, direction);
    gram += weight * values * values.transpose();
  }
  EXPECT_LT((gram - Eigen::MatrixXd::Identity(count, count)).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(SphericalHarmonics, FollowTheConvention)
{
  const Vector3 d = Vector3(1, 2, -3).normalized();
  const double first = std::sqrt(3 / (4 * std::numbers::pi));
  EXPECT_NEAR(real_spherical_harmonic(0, 0, d), std::sqrt(0.25 / std::numbers::pi), 1e-15);
  EXPECT_NEAR(real_spherical_harmonic(1, 0, d), first * d.z(), 1e-15);
  EXPECT_NEAR(real_spherical_harmonic(1, 1, d), first * d.x(), 1e-15);
  EXPECT_NEAR(real_spherical_harmonic(1, -1, d), first * d.y(), 1e-15);
  EXPECT_NEAR(real_spherical_harmonic(2, -2, d),
    std::sqrt(15 / (4 * std::numbers::pi)) * d.x() * d.y(), 1e-15);
  EXPECT_EQ(real_spherical_harmonic(5, 3, Vector3::UnitZ()), 0);
  EXPECT_THROW(real_spherical_harmonic(1, 2, d), InputError);
}

}
