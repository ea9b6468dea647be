#include "solver/mesh/LeastSquares.h"

#include <Eigen/QR>

namespace vesicle
{

std::optional<Eigen::VectorXd> least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b)
{
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(A);
  if (qr.rank() < A.cols())
    return std::nullopt;
  return qr.solve(b);
}

LeastNorm least_norm(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B, double threshold)
{
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> qr;
  qr.setThreshold(threshold);
  qr.compute(A);
  return { qr.solve(B), qr.rank() };
}

}
