#include "solver/linear/GroupedRows.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace vesicle
{
namespace
{

using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

// Groups of three rows with 0, 1, 2, … columns in common, as many as there are.
Matrix groups(int count)
{
  std::mt19937 random(1);
  std::normal_distribution<double> value;
  std::vector<Eigen::Triplet<double>> entries;
  for (int group = 0; group < count; ++group)
    for (int k = 0; k < group; ++k)
      for (int r = 0; r < 3; ++r)
        entries.emplace_back(3 * group + r, (7 * k + group) % count, value(random));
  Matrix A(3 * count, count);
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

TEST(GroupedRows, ProductsAreThoseOfTheRowsOneByOne)
{
  const Matrix A = groups(29);
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(A.cols(), -1, 2), exact = A * x;
  for (const int together : { 1, 3 })
    EXPECT_LT((multiply_grouped(A, together, x) - exact).norm(), 1e-15 * A.norm() * x.norm());
}

}
}
