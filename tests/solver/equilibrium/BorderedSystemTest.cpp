#include "solver/equilibrium/BorderedSystem.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <gtest/gtest.h>

#include <cmath>

namespace vesicle
{
namespace
{

// A symmetric matrix with eigenvalues of either sign, two constraints and a part of rank one.
struct Example
{
  static constexpr int n = 12;
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n), B = Eigen::MatrixXd(n, 3);
  Eigen::VectorXd D = Eigen::Vector3d(0, 0, 0.5);

  explicit Example(double shift)
  {
    for (int i = 0; i < n; ++i)
    {
      K(i, i) = shift + i - 3.3;
      for (int j = 0; j < i; ++j)
        K(i, j) = K(j, i) = 0.3 * std::sin(i * j + 1.);
      for (int k = 0; k < 3; ++k)
        B(i, k) = std::cos(1 + 1.7 * i * (k + 1));
    }
  }
  void compute(BorderedSystem& system) const
  {
    const Eigen::MatrixXd lower = K.triangularView<Eigen::Lower>();
    system.compute(lower.sparseView(), B, D);
  }
  /// K + u uᵀ/d on the null space of the constraints.
  Eigen::VectorXd eigenvalues() const
  {
    const Eigen::MatrixXd full = K + B.col(2) * B.col(2).transpose() / D[2];
    const Eigen::MatrixXd kernel =
      Eigen::FullPivLU<Eigen::MatrixXd>(B.leftCols(2).transpose()).kernel();
    return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(
      kernel.transpose() * full * kernel, kernel.transpose() * kernel)
      .eigenvalues();
  }
};

TEST(BorderedSystem, SolvesTheWhole)
{
  const Example example(0);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(Example::n, -1, 2);
  const Eigen::Vector3d c(0.3, -0.2, 0);
  Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(Example::n + 3, Example::n + 3);
  whole << example.K, example.B, example.B.transpose(),
    Eigen::MatrixXd(-Eigen::MatrixXd(example.D.asDiagonal()));
  Eigen::VectorXd right(Example::n + 3);
  right << b, c;
  const Eigen::VectorXd exact = whole.partialPivLu().solve(right);
  BorderedSystem system;
  example.compute(system);
  const auto solution = system.solve(b, c);
  EXPECT_LT((solution.x - exact.head(Example::n)).norm(), 1e-12 * exact.norm());
  EXPECT_LT((solution.y - exact.tail(3)).norm(), 1e-12 * exact.norm());
}

TEST(BorderedSystem, CountsTheDirectionsDownhill)
{
  for (const double shift : { -4., -1., 0., 1., 2., 5. })
  {
    const Example example(shift);
    BorderedSystem system;
    example.compute(system);
    EXPECT_EQ(system.index(), (example.eigenvalues().array() < 0).count()) << shift;
  }
}

}
}
