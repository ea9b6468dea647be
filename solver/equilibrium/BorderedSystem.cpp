#include "solver/equilibrium/BorderedSystem.h"

#include "solver/Errors.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace vesicle
{

void BorderedSystem::compute(
  const SymmetricMatrix& K, const Eigen::MatrixXd& B, const Eigen::VectorXd& D)
{
  factors_.compute(K);
  if (!factors_.regular())
    throw NumericalError("the second variation of the energy can't be factorised");
  border_ = B;
  solved_border_ = factors_.solve(B);
  schur_ = B.transpose() * solved_border_;
  schur_ = ((schur_ + schur_.transpose()) / 2).eval();
  schur_.diagonal() += D;
  const Eigen::VectorXd& pivots = factors_.pivots();
  const Eigen::VectorXd of_border =
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(schur_, Eigen::EigenvaluesOnly).eigenvalues();
  index_ =
    static_cast<int>((pivots.array() < 0).count() + (of_border.array() > 0).count() - B.cols());
}

BorderedSystem::Solution BorderedSystem::solve(
  const Eigen::VectorXd& b, const Eigen::VectorXd& c) const
{
  const Eigen::VectorXd x = factors_.solve(b);
  const Eigen::VectorXd y = schur_.colPivHouseholderQr().solve(border_.transpose() * x - c);
  return { x - solved_border_ * y, y };
}

}
