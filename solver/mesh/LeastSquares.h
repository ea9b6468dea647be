#pragma once
// Least squares for small dense systems. One place for them, since every file that sees Eigen's
// decompositions compiles them anew.

#include <Eigen/Core>

#include <optional>

namespace vesicle
{

/// The x of least |A x − b|, by QR with column pivoting; none where the columns of A depend on each
/// other within rounding.
std::optional<Eigen::VectorXd> least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

struct LeastNorm
{
  Eigen::MatrixXd X;
  Eigen::Index rank; ///< of A
};

/// Of all X of least |A X − B| that of least norm, by a complete orthogonal decomposition: pivots
/// below `threshold` times the largest count as zero.
LeastNorm least_norm(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B, double threshold);

}
