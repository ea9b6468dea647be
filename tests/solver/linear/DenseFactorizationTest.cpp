#include "solver/linear/DenseFactorization.h"

#include "solver/Errors.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

namespace vesicle
{
namespace
{

// Several panels and tasks, and not a multiple of either.
constexpr int size = 517;

Eigen::MatrixXf matrix()
{
  std::srand(1);
  Eigen::MatrixXf A = Eigen::MatrixXf::Random(size, size);
  A.row(3) *= 1e6f; // row scaling has to cope with rows of different units
  A.row(200) *= 1e-6f;
  return A;
}

TEST(DenseFactorization, SolvesToSinglePrecision)
{
  const Eigen::MatrixXf A = matrix();
  DenseFactorization lu;
  lu.compute(A);
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(size, -1, 2);
  const Eigen::VectorXd b = A.cast<double>() * x;
  EXPECT_LT((lu.solve(b) - x).norm() / x.norm(), 2e-3); // single precision, a random matrix
  EXPECT_EQ(lu.size(), size);
}

TEST(DenseFactorization, DoesNotDependOnTheNumberOfThreads)
{
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(size, -1, 2);
  Eigen::VectorXd x[2];
  for (int threads : { 1, 4 })
  {
    tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    DenseFactorization lu;
    lu.compute(matrix());
    x[threads > 1] = lu.solve(b);
  }
  EXPECT_EQ(x[0], x[1]);
}

TEST(DenseFactorization, SaysThatAMatrixIsSingular)
{
  Eigen::MatrixXf A = matrix();
  A.row(5).setZero();
  DenseFactorization lu;
  EXPECT_THROW(lu.compute(A), NumericalError);
  A = Eigen::MatrixXf::Ones(4, 4);
  EXPECT_THROW(lu.compute(A), NumericalError);
}

TEST(DenseFactorization, RightSidesOfAnySize)
{
  const Eigen::MatrixXf A = matrix();
  DenseFactorization lu;
  lu.compute(A);
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(size);
  const Eigen::VectorXd x = lu.solve(b);
  EXPECT_LT((lu.solve(1e-60 * b) * 1e60 - x).norm(), 1e-12 * x.norm());
  EXPECT_EQ(lu.solve(0 * b), Eigen::VectorXd::Zero(size));
}

}
}
