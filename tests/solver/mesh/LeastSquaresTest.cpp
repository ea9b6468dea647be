#include "solver/mesh/LeastSquares.h"

#include <gtest/gtest.h>

namespace vesicle::test
{

namespace
{
/// Columns 1, x and x² at five points.
Eigen::MatrixXd parabola()
{
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(5, -1, 1);
  Eigen::MatrixXd A(5, 3);
  A << Eigen::VectorXd::Ones(5), x, x.cwiseAbs2();
  return A;
}

/// The last column is the sum of the others.
Eigen::MatrixXd dependent()
{
  Eigen::MatrixXd A = parabola();
  A.col(2) = A.col(0) + A.col(1);
  return A;
}

// Any right-hand side that A's columns don't span.
const Eigen::VectorXd b{ { 1, -2, 0.5, 3, 0 } };
}

TEST(LeastSquares, TheResidualIsNormalToTheColumns)
{
  const auto x = least_squares(parabola(), b);
  ASSERT_TRUE(x);
  EXPECT_LT((parabola().transpose() * (parabola() * *x - b)).norm(), 1e-14);
}

TEST(LeastSquares, NoneIfColumnsDependOnEachOther)
{
  EXPECT_FALSE(least_squares(dependent(), b));
}

TEST(LeastNorm, IsTheLeastSquaresSolutionAtFullRank)
{
  const LeastNorm found = least_norm(parabola(), b, 1e-6);
  EXPECT_EQ(found.rank, 3);
  EXPECT_LT((found.X.col(0) - *least_squares(parabola(), b)).norm(), 1e-14);
}

// Of least norm: normal to (1, 1, −1), along which A x stays as it is.
TEST(LeastNorm, HasNoPartThatMakesNoDifference)
{
  const LeastNorm found = least_norm(dependent(), b, 1e-6);
  EXPECT_EQ(found.rank, 2);
  EXPECT_LT((dependent().transpose() * (dependent() * found.X - b)).norm(), 1e-14);
  EXPECT_NEAR(found.X(0) + found.X(1) - found.X(2), 0, 1e-14);
}

}
