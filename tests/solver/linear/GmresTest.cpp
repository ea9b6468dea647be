#include "solver/linear/Gmres.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <vector>

namespace vesicle
{
namespace
{

Eigen::VectorXd identity(const Eigen::VectorXd& x)
{
  return x;
}

TEST(Gmres, SolvesWithoutAPreconditionerInAtMostNIterations)
{
  std::srand(2);
  const int n = 30;
  const Eigen::MatrixXd A = Eigen::MatrixXd::Random(n, n) + 3 * Eigen::MatrixXd::Identity(n, n);
  const Eigen::VectorXd x = Eigen::VectorXd::Random(n);
  const auto result = gmres(
    [&](const Eigen::VectorXd& v) -> Eigen::VectorXd { return A * v; }, identity, A* x, 1e-12, n);
  EXPECT_LE(result.residual, 1e-12);
  EXPECT_LT((result.solution - x).norm(), 1e-9);
}

TEST(Gmres, NeedsOneIterationWithTheInverseAndReportsTheTrueResidual)
{
  std::srand(3);
  const int n = 20;
  const Eigen::MatrixXd A = Eigen::MatrixXd::Random(n, n);
  const Eigen::PartialPivLU<Eigen::MatrixXd> lu(A);
  const Eigen::VectorXd b = Eigen::VectorXd::Random(n);
  const auto result = gmres([&](const Eigen::VectorXd& v) -> Eigen::VectorXd { return A * v; },
    [&](const Eigen::VectorXd& v) -> Eigen::VectorXd { return lu.solve(v); }, b, 1e-10, n);
  EXPECT_EQ(result.iterations, 1);
  EXPECT_LT((A * result.solution - b).norm(), 1e-10 * b.norm());
}

// Errors as large as allowed: the true residual is still what was wanted.
TEST(Gmres, ErrorsThatAreAllowedDontCount)
{
  std::srand(5);
  const int n = 200;
  const Eigen::MatrixXd A =
    Eigen::MatrixXd::Identity(n, n) + 0.4 / std::sqrt(n) * Eigen::MatrixXd::Random(n, n);
  const Eigen::VectorXd b = Eigen::VectorXd::Random(n);
  const double wanted = 1e-10 * b.norm();
  double largest = 0;
  std::vector<Eigen::VectorXd> images;
  const auto result = gmres(
    [&](const Eigen::VectorXd& x, double allowed) -> Eigen::VectorXd
    {
      largest = std::max(largest, allowed);
      const Eigen::VectorXd y = A * x;
      images.push_back(y + allowed * y.norm() * Eigen::VectorXd::Random(n).normalized());
      return images.back();
    },
    identity, b, [&](const Eigen::VectorXd&) { return wanted; }, n);
  EXPECT_TRUE(result.converged);
  EXPECT_GT(largest, 1e-3);
  EXPECT_LT((b - A * result.solution).norm(), 1.5 * wanted);
  // What the images add up to is as good as another A x.
  Eigen::VectorXd image = Eigen::VectorXd::Zero(n);
  for (std::size_t i = 0; i < images.size(); ++i)
    image += result.coefficients[static_cast<Eigen::Index>(i)] * images[i];
  EXPECT_LT((image - A * result.solution).norm(), wanted);
}

TEST(Gmres, ZeroRightSideGivesZero)
{
  const auto result = gmres(identity, identity, Eigen::VectorXd::Zero(5), 1e-12, 5);
  EXPECT_EQ(result.solution, Eigen::VectorXd::Zero(5));
  EXPECT_EQ(result.iterations, 0);
}

TEST(Gmres, StopsAtTheLimitAndSaysHowFarItGot)
{
  std::srand(4);
  const Eigen::MatrixXd A = Eigen::MatrixXd::Random(40, 40);
  const Eigen::VectorXd b = Eigen::VectorXd::Random(40);
  const auto result = gmres(
    [&](const Eigen::VectorXd& v) -> Eigen::VectorXd { return A * v; }, identity, b, 1e-12, 3);
  EXPECT_EQ(result.iterations, 3);
  EXPECT_NEAR(result.residual, (A * result.solution - b).norm() / b.norm(), 1e-10);
}

}
}
