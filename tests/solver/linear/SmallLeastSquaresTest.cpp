#include "solver/linear/SmallLeastSquares.h"

#include <Eigen/QR>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <span>
#include <utility>

namespace vesicle::test
{
namespace
{

/// Columns of very different lengths, as those of monomials are.
Eigen::MatrixXd random_matrix(int rows, int columns, std::mt19937& random)
{
  std::normal_distribution<double> number;
  Eigen::MatrixXd A = Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return number(random); });
  for (int j = 0; j < columns; ++j)
    A.col(j) *= std::pow(0.1, j % 5);
  return A;
}

void write(const Eigen::MatrixXd& A, const Eigen::VectorXd& b, SmallLeastSquares& equations)
{
  const auto rows = A.rows();
  equations.resize(static_cast<int>(rows), static_cast<int>(A.cols()));
  for (int j = 0; j < A.cols(); ++j)
    Eigen::Map<Eigen::VectorXd>(equations.column(j), rows) = A.col(j);
  Eigen::Map<Eigen::VectorXd>(equations.right_side(), rows) = b;
}

Eigen::VectorXd vector(std::span<const double> values)
{
  return Eigen::Map<const Eigen::VectorXd>(values.data(), std::ssize(values));
}

}

TEST(SmallLeastSquares, IsTheSolutionByReflections)
{
  std::mt19937 random(7);
  SmallLeastSquares equations; // the same for all sizes, larger and smaller ones
  for (const auto& [rows, columns] :
    { std::pair(36, 14), { 5, 5 }, { 700, 15 }, { 9, 3 }, { 1, 1 } })
  {
    const Eigen::MatrixXd A = random_matrix(rows, columns, random);
    const Eigen::VectorXd b = random_matrix(rows, 1, random), g = random_matrix(columns, 1, random);
    write(A, b, equations);
    ASSERT_TRUE(equations.solve(1e-6));
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(A);
    const Eigen::VectorXd x = qr.solve(b);
    EXPECT_LT((vector(equations.solution()) - x).norm(), 1e-11 * x.norm()) << rows;
    EXPECT_NEAR(equations.residual(), (A * x - b).norm(), 1e-13 * b.norm()) << rows;
    const Eigen::VectorXd w = vector(equations.functional({ g.data(), std::size_t(columns) }));
    const Eigen::VectorXd expected =
      qr.solve(Eigen::MatrixXd::Identity(rows, rows)).transpose() * g;
    ASSERT_EQ(w.size(), rows);
    EXPECT_LT((w - expected).norm(), 1e-11 * expected.norm()) << rows;
    const Eigen::VectorXd hat = (A * qr.solve(Eigen::MatrixXd::Identity(rows, rows))).diagonal();
    EXPECT_LT((vector(equations.leverages()) - hat).norm(), 1e-11) << rows;
  }
}

TEST(SmallLeastSquares, NoSolutionWhereColumnsDependOnEachOther)
{
  std::mt19937 random(7);
  SmallLeastSquares equations;
  for (const double apart : { 0., 1e-8, 1e-4 })
  {
    Eigen::MatrixXd A = random_matrix(20, 5, random);
    const double length = A.col(3).norm();
    A.col(3) = A.col(0) - 2 * A.col(1) + apart * A.col(3) / length;
    write(A, A.col(4), equations);
    EXPECT_EQ(equations.solve(1e-6), apart > 1e-6) << apart;
  }
  Eigen::MatrixXd A = random_matrix(20, 5, random);
  A.col(2).setZero();
  write(A, A.col(4), equations);
  EXPECT_FALSE(equations.solve(1e-6));
  A.col(2).setConstant(std::nan(""));
  write(A, A.col(4), equations);
  EXPECT_FALSE(equations.solve(1e-6));
}

TEST(SmallLeastSquares, ScaledColumnsAreTheSameEquations)
{
  std::mt19937 random(7);
  const Eigen::MatrixXd A = random_matrix(30, 9, random);
  SmallLeastSquares equations;
  write(A, A.rowwise().sum(), equations);
  ASSERT_TRUE(equations.solve(1e-6));
  EXPECT_LT((vector(equations.solution()) - Eigen::VectorXd::Ones(9)).norm(), 1e-11);
  write(A * 1e-9, A.rowwise().sum(), equations);
  ASSERT_TRUE(equations.solve(1e-6));
  EXPECT_LT((1e-9 * vector(equations.solution()) - Eigen::VectorXd::Ones(9)).norm(), 1e-11);
}

}
