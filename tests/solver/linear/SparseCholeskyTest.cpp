#include "solver/linear/SparseCholesky.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace vesicle
{
namespace
{

using Entries = std::vector<Eigen::Triplet<double>>;

SymmetricMatrix matrix(int size, const Entries& entries)
{
  SymmetricMatrix A(size, size);
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

// Positive definite: `parts` grids of width by width nodes, each joined to those up to two away, with
// random weights.
SymmetricMatrix grids(int width, int parts, int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> weight(0.1, 1);
  Entries entries;
  const auto index = [&](int part, int i, int j) { return (part * width + i) * width + j; };
  for (int part = 0; part < parts; ++part)
    for (int i = 0; i < width; ++i)
      for (int j = 0; j < width; ++j)
        for (int di = 0; di <= 2 && i + di < width; ++di)
          for (int dj = di == 0 ? 0 : -2; dj <= 2; ++dj)
          {
            if (j + dj < 0 || j + dj >= width)
              continue;
            const int a = index(part, i, j), b = index(part, i + di, j + dj);
            const double w = weight(random);
            if (a == b)
              entries.emplace_back(a, a, w);
            else
              entries.insert(
                entries.end(), { { a, a, w }, { b, b, w }, { a, b, -w }, { b, a, -w } });
          }
  return matrix(parts * width * width, entries);
}

// [A Bᵀ; B −F] with a B of few entries a row: quasi-definite, so that any order has its LDLᵀ
// (Vanderbei, SIAM J. Optim. 5 (1995) 100).
SymmetricMatrix saddle(const SymmetricMatrix& A, int rows)
{
  std::mt19937 random(3);
  std::normal_distribution<double> value;
  std::uniform_int_distribution<int> column(0, static_cast<int>(A.cols()) - 1);
  Entries entries;
  for (int j = 0; j < A.cols(); ++j)
    for (SymmetricMatrix::InnerIterator it(A, j); it; ++it)
      entries.emplace_back(it.row(), j, it.value());
  const int n = static_cast<int>(A.cols());
  for (int i = 0; i < rows; ++i)
  {
    for (int k = 0; k < 5; ++k)
    {
      const int j = (i * n / rows + column(random) / 4) % n;
      const double b = value(random);
      entries.insert(entries.end(), { { n + i, j, b }, { j, n + i, b } });
    }
    entries.emplace_back(n + i, n + i, -1e-2);
  }
  return matrix(n + rows, entries);
}

Eigen::MatrixXd right_sides(Eigen::Index rows)
{
  std::srand(7);
  return Eigen::MatrixXd::Random(rows, 3);
}

// |A x − b|/(|A||x|): a backward stable solution's is a few roundings.
template<class Scalar>
double backward_error(const SymmetricMatrix& A, const SupernodalCholesky<Scalar>& factors)
{
  const Eigen::MatrixXd b = right_sides(A.rows()), x = factors.solve(b);
  return (A * x - b).norm() / (A.norm() * x.norm());
}

TEST(SparseCholesky, SolvesPositiveDefiniteSystems)
{
  for (const int width : { 1, 2, 3, 9, 24 })
    for (const int parts : { 1, 3 })
    {
      const SymmetricMatrix A = grids(width, parts, width);
      const SparseCholesky factors(A);
      ASSERT_TRUE(factors.regular());
      EXPECT_TRUE((factors.pivots().array() > 0).all());
      EXPECT_LT(backward_error(A, factors), 1e-15) << width << " " << parts;
    }
}

TEST(SparseCholesky, FindsTheDenseInverse)
{
  const SymmetricMatrix A = grids(7, 2, 1);
  const Eigen::MatrixXd inverse =
    SparseCholesky(A).solve(Eigen::MatrixXd(Eigen::MatrixXd::Identity(A.rows(), A.rows())));
  const Eigen::MatrixXd exact = Eigen::MatrixXd(A).inverse();
  EXPECT_LT((inverse - exact).norm() / exact.norm(), 1e-13);
}

TEST(SparseCholesky, SolvesSaddlePointsWithoutPivoting)
{
  const SymmetricMatrix A = saddle(grids(12, 1, 5), 70);
  const SparseCholesky factors(A);
  ASSERT_TRUE(factors.regular());
  EXPECT_LT(backward_error(A, factors), 1e-12); // pivots of 1e-2 beside entries of 1
}

TEST(SparseCholesky, PivotsHaveTheSignsOfTheEigenvalues)
{
  const SymmetricMatrix A = saddle(grids(8, 1, 5), 30);
  const Eigen::VectorXd eigenvalues =
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(Eigen::MatrixXd(A), Eigen::EigenvaluesOnly)
      .eigenvalues();
  EXPECT_EQ((SparseCholesky(A).pivots().array() < 0).count(), (eigenvalues.array() < 0).count());
}

TEST(SparseCholesky, ReadsTheLowerTriangleAlone)
{
  const SymmetricMatrix A = grids(9, 1, 2);
  const SymmetricMatrix lower = A.triangularView<Eigen::Lower>();
  const Eigen::MatrixXd b = right_sides(A.rows());
  EXPECT_EQ(SparseCholesky(A).solve(b), SparseCholesky(lower).solve(b));
}

TEST(SparseCholesky, ColumnsAreSolvedAsOneByOne)
{
  const SymmetricMatrix A = grids(9, 1, 2);
  const SparseCholesky factors(A);
  const Eigen::MatrixXd b = right_sides(A.rows()), x = factors.solve(b);
  const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> rows = b;
  EXPECT_EQ(Eigen::MatrixXd(factors.solve(rows)), x);
  for (int c = 0; c < 3; ++c)
    EXPECT_LT(
      (factors.solve(Eigen::VectorXd(b.col(c))) - x.col(c)).norm(), 1e-13 * x.col(c).norm());
}

TEST(SparseCholesky, AKnownPatternIsNotAnalysedAgain)
{
  const SymmetricMatrix first = grids(9, 1, 1), second = grids(9, 1, 2), other = grids(8, 1, 1);
  const EliminationPlans plans;
  EXPECT_EQ(plans.of(first), plans.of(second));
  EXPECT_NE(plans.of(first), plans.of(other));
  SparseCholesky factors(first, plans);
  const auto solution = [](const SparseCholesky& by, Eigen::Index size) -> Eigen::MatrixXd
  { return by.solve(right_sides(size)); };
  for (const SymmetricMatrix& A : { second, other, first })
  {
    factors.compute(A, plans);
    EXPECT_EQ(solution(factors, A.rows()), solution(SparseCholesky(A), A.rows()));
  }
}

TEST(SparseCholesky, SinglePrecisionIsOffByItsRounding)
{
  const SymmetricMatrix A = grids(15, 1, 4);
  EXPECT_LT(backward_error(A, SupernodalCholesky<float>(A)), 5e-7);
}

TEST(SparseCholesky, SingularMatricesAreToldApart)
{
  EXPECT_FALSE(SparseCholesky(matrix(3, { { 0, 0, 1. }, { 1, 1, 0. }, { 2, 2, 1. } })).regular());
  EXPECT_FALSE(SparseCholesky(matrix(1, { { 0, 0, std::nan("") } })).regular());
}

// The factor of a matrix that is full in one row and column has no more entries than the matrix, where
// that one goes last; up to four are stored for each (four columns may go together whatever is zero).
TEST(EliminationPlan, AnArrowFillsNothingIn)
{
  constexpr int size = 200;
  Entries entries;
  for (int i = 0; i < size; ++i)
  {
    entries.emplace_back(i, i, 2.);
    if (i > 0)
      entries.emplace_back(i, 0, 0.1); // the dense column is the first: it has to go last
  }
  const SymmetricMatrix A = matrix(size, entries);
  const EliminationPlan plan(A);
  EXPECT_EQ(plan.size(), size);
  EXPECT_LT(plan.panel_entries(), 4 * A.nonZeros());
}

}
}
