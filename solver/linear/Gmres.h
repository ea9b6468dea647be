#pragma once
// GMRES with right preconditioning (Saad & Schultz, SIAM J. Sci. Stat. Comput. 7 (1986) 856),
// without restarts: with the preconditioners used here it ends after a few iterations. Sums are
// sequential, so results do not depend on the number of threads. (Eigen's GMRES preconditions from
// the left and measures the preconditioned residual against that of the first guess; here the true
// residual counts.)

#include <Eigen/Core>

#include <functional>

namespace vesicle
{

using LinearMap = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;
/// A x with a relative error up to `allowed`.
using InexactMap = std::function<Eigen::VectorXd(const Eigen::VectorXd& x, double allowed)>;

struct GmresResult
{
  Eigen::VectorXd solution;
  Eigen::VectorXd coefficients; ///< its own in the preconditioned basis
  int iterations = 0;
  double residual = 0; ///< ‖b − A x‖/‖b‖ as the recurrence estimates it
  bool converged = false;
};

/// Solves A x = b to the relative residual `tolerance` or until `max_iterations`.
GmresResult gmres(const LinearMap& A, const LinearMap& preconditioner, const Eigen::VectorXd& b,
  double tolerance, int max_iterations);
/// The same until ‖b − A x‖ is at most what `wanted` says of x's coefficients in the preconditioned
/// basis, of which the i-th was the argument of the i-th call of A. Asked where the residual has
/// fallen below what was wanted last. The smaller the residual is already, the less A's errors count
/// (Simoncini & Szyld, SIAM J. Sci. Comput. 25 (2003) 454): a tenth of what is wanted is allowed.
GmresResult gmres(const InexactMap& A, const LinearMap& preconditioner, const Eigen::VectorXd& b,
  const std::function<double(const Eigen::VectorXd&)>& wanted, int max_iterations);

}
