#pragma once
// The map between control points and vertices: x = P c puts the vertices on the surface of the
// control points c, velocities are collocated there, and everything that is known at the vertices
// reaches the basis through P⁻¹. P is the identity on flat triangles.

#include "solver/linear/SparseCholesky.h"
#include "solver/surface/Basis.h"

#include <Eigen/Core>

namespace vesicle
{

/// Vectors have 3 entries a node (x, y, z interleaved), 3N in all.
class Collocation
{
public:
  /// Throws InputError if the mesh has no such surface.
  explicit Collocation(const Basis& basis);

  /// P: values at the vertices of a nodal scalar, N.
  Eigen::VectorXd at_vertices(const Eigen::VectorXd& nodal) const;
  /// P⁻¹ of N by m columns: what a field has at the control points from its values at the vertices.
  Eigen::MatrixXd fit(const Eigen::MatrixXd& at_vertices) const;
  /// P⁻ᵀ of N by m columns: functionals of the values at the vertices from those of the control
  /// points' values.
  Eigen::MatrixXd fit_adjoint(const Eigen::MatrixXd& of_control) const;
  /// P⁻¹ of a vector: velocities of the control points from those of the vertices.
  Eigen::VectorXd to_control(const Eigen::VectorXd& at_vertices) const;
  /// P of a vector, and Pᵀ: of the vertices' velocities from the control points', of functionals the
  /// other way.
  Eigen::VectorXd to_vertices(const Eigen::VectorXd& control) const;
  Eigen::VectorXd to_vertices_adjoint(const Eigen::VectorXd& functional) const;
  /// P⁻ᵀ of a vector: the gradient with respect to the vertices from that with respect to the
  /// control points.
  Eigen::VectorXd from_control(const Eigen::VectorXd& gradient) const;
  /// P.
  const SparseMatrix& matrix() const { return P_; }

private:
  SparseMatrix P_;
  bool smooth_; ///< false: P is the identity
  // P = diag(1/unscale) S, S symmetric.
  Eigen::VectorXd unscale_;
  SparseCholesky symmetric_;
};

/// 3N view of N by 3 points, and back.
inline Eigen::Map<const Eigen::VectorXd> flat(const Points& points)
{
  return { points.data(), points.size() };
}
inline Points rows_of_three(const Eigen::VectorXd& vector)
{
  return Eigen::Map<const Points>(vector.data(), vector.size() / 3, 3);
}
/// Each row of `points` times its factor, as 3N.
inline Eigen::VectorXd scaled_rows(const Points& points, const Eigen::VectorXd& factor)
{
  return flat((points.array().colwise() * factor.array()).matrix().eval());
}

}
