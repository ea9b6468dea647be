#include "solver/linear/Gmres.h"

#include <Eigen/Jacobi>

#include <vector>

namespace vesicle
{

GmresResult gmres(const LinearMap& A, const LinearMap& preconditioner, const Eigen::VectorXd& b,
  double tolerance, int max_iterations)
{
  const double wanted = tolerance * b.norm();
  return gmres([&](const Eigen::VectorXd& x, double) { return A(x); }, preconditioner, b,
    [&](const Eigen::VectorXd&) { return wanted; }, max_iterations);
}

GmresResult gmres(const InexactMap& A, const LinearMap& preconditioner, const Eigen::VectorXd& b,
  const std::function<double(const Eigen::VectorXd&)>& wanted, int max_iterations)
{
  constexpr double allowed_share = 0.1;
  const double norm = b.norm();
  double target = wanted({});
  if (!(norm > target))
    return { Eigen::VectorXd::Zero(b.size()), {}, 0, norm > 0 ? 1. : 0., true };

  std::vector<Eigen::VectorXd> basis{ b / norm }, preconditioned;
  Eigen::MatrixXd R = Eigen::MatrixXd::Zero(max_iterations + 1, max_iterations);
  Eigen::VectorXd g = Eigen::VectorXd::Zero(max_iterations + 1);
  g[0] = norm;
  std::vector<Eigen::JacobiRotation<double>> rotations;
  int k = 0;
  const auto coefficients = [&]() -> Eigen::VectorXd
  { return R.topLeftCorner(k, k).triangularView<Eigen::Upper>().solve(g.head(k)); };
  const auto converged = [&]
  {
    if (std::abs(g[k]) > target)
      return false;
    target = wanted(coefficients());
    return std::abs(g[k]) <= target;
  };
  while (k < max_iterations && !converged())
  {
    preconditioned.push_back(preconditioner(basis[k]));
    Eigen::VectorXd w = A(preconditioned[k], allowed_share * target / std::abs(g[k]));
    for (int pass = 0; pass < 2; ++pass) // twice is enough: orthogonal to rounding
      for (int i = 0; i <= k; ++i)
      {
        const double h = basis[i].dot(w);
        R(i, k) += h;
        w -= h * basis[i];
      }
    const double h = w.norm();
    R(k + 1, k) = h;
    for (int i = 0; i < k; ++i)
      R.col(k).applyOnTheLeft(i, i + 1, rotations[i].adjoint());
    Eigen::JacobiRotation<double> rotation;
    rotation.makeGivens(R(k, k), R(k + 1, k));
    R.col(k).applyOnTheLeft(k, k + 1, rotation.adjoint());
    g.applyOnTheLeft(k, k + 1, rotation.adjoint());
    rotations.push_back(rotation);
    ++k;
    if (!(h > 0))
      break; // the solution lies in the space spanned
    basis.emplace_back(w / h);
  }

  const Eigen::VectorXd y = coefficients();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size());
  for (int i = 0; i < k; ++i)
    x += y[i] * preconditioned[i];
  return { x, y, k, std::abs(g[k]) / norm, std::abs(g[k]) <= target };
}

}
