#pragma once
// How a shape becomes operators: flat linear elements, or Loop's limit surface. In both the unknown
// positions x are the vertices on the surface, where velocities are collocated; a smooth basis has
// control points c with x = P c beside them.

#include "solver/dynamics/Model.h"
#include "solver/surface/Cotan.h"
#include "solver/stokes/SingleLayer.h"

#include <memory>

namespace vesicle
{

/// Area and volume of a shape, their derivatives, and directions in which a shape is corrected.
/// Vectors have 3 entries a vertex.
struct Constraints
{
  double area, volume;
  Eigen::VectorXd area_gradient, volume_gradient;   ///< ∂A/∂x, ∂V/∂x
  Eigen::VectorXd area_direction, volume_direction; ///< about 2 H n and n
};

/// Everything about one shape. Densities are forces an area, the membrane's on the fluid. A term
/// that the scene doesn't have is empty.
struct ShapeOperators
{
  Points vertices, control; ///< the same for linear elements
  double area, volume;
  Vector3 center;              ///< centroid of the volume
  Eigen::VectorXd vertex_area; ///< ∮ N_k dS
  Points outward;              ///< unit normals at the vertices
  Curvature curvature;         ///< at the vertices
  double bending_energy;       ///< EB = 1

  // Act on velocities at the vertices.
  Eigen::VectorXd volume_gradient;                            ///< ∂V/∂x
  Eigen::Matrix<double, 3, Eigen::Dynamic> centroid_velocity; ///< W: U = W u

  // Act on velocities of the control points.
  SparseMatrix area_rate;         ///< B: d(∮ N_k dS)/dt, N by 3N
  SparseMatrix divergence;        ///< the constraint's rows, or empty
  SparseMatrix divergence_filter; ///< added to the constraint's rows, acts on γ: N by N, or empty
  SparseMatrix bending_response;  ///< R: M δφ = R δc, N by 3N, or empty

  SparseMatrix bending_mass;  ///< M; empty: identity
  Eigen::VectorXd bending;    ///< φ: nodal normal density of bending, or empty
  Eigen::VectorXd load;       ///< gravity's nodal density: 3N (linear), N along the normal (Loop)
  Eigen::VectorXd ambient;    ///< u∞ at the vertices: 3N
  Points force_normal;        ///< linear elements: nodal direction of φ
  SparseMatrix tension_force; ///< linear elements: T, nodal density of a tension, 3N by N

  /// True where the shape is so close to a sphere that a uniform tension does no work: then the
  /// total area follows from the volume, and the gauge of the tension is fixed to a zero mean.
  bool gauge_pinned = false;
};

/// A surface and a vector field on it on flat triangles, fine enough to measure along lines.
struct FlatSample
{
  TriangleMesh mesh;
  Points field;
};

class Discretization
{
public:
  using RowsF = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  virtual ~Discretization() = default;

  /// Integrates over the surface; its nodes are the control points.
  virtual const BasisTable& table() const = 0;

  virtual ShapeOperators shape(const Points& vertices) const = 0;
  virtual Constraints constraints(const Points& vertices) const = 0;
  virtual double bending_energy(const Points& vertices) const = 0;
  /// Velocities that bending, tension and gravity make at that shape.
  virtual void respond(const ShapeOperators& shape, VelocityResponse& response) const = 0;

  /// Velocities of the control points from those of the vertices, P⁻¹: 3N.
  virtual Eigen::VectorXd to_control(const Eigen::VectorXd& velocity) const = 0;
  /// The same for each column of a 3N by m matrix, approximately: for preconditioning.
  virtual void to_control(RowsF& velocities) const = 0;

  /// Vector densities at the vertices, 3N: bending for a nodal φ, tension for a nodal γ, gravity.
  virtual Eigen::VectorXd bending_force(
    const ShapeOperators& shape, const Eigen::VectorXd& phi) const = 0;
  virtual Eigen::VectorXd tension_force(
    const ShapeOperators& shape, const Eigen::VectorXd& gamma) const = 0;
  virtual Eigen::VectorXd load_force(const ShapeOperators& shape) const = 0;
  /// ∮ f·v dS for the forces of bending and tension (φ and γ may be empty), and for gravity's, v
  /// given at the vertices.
  virtual double membrane_power(const ShapeOperators& shape, const Eigen::VectorXd& phi,
    const Eigen::VectorXd& gamma, const Eigen::VectorXd& velocity) const = 0;
  virtual double load_power(const ShapeOperators& shape, const Eigen::VectorXd& velocity) const = 0;
  /// At least the part of the surface that the plane y = `height` cuts; `field` is given at the
  /// vertices. Points may be repeated.
  virtual FlatSample sample_around(
    double height, const ShapeOperators& shape, const Points& field) const = 0;
  /// A nodal scalar's values at the vertices: N.
  virtual Eigen::VectorXd at_vertices(const Eigen::VectorXd& nodal) const = 0;
};

std::unique_ptr<Discretization> make_linear_discretization(
  const Model& model, const Triangles& triangles, int nodes, int quadrature);
std::unique_ptr<Discretization> make_loop_discretization(
  const Model& model, const Triangles& triangles, int nodes, int quadrature);

/// A relative deviation of the nodes' distance to the centre below 1e-3 counts as a sphere: the
/// area in excess of a sphere's, its square, is then below 1e-6 and far below what the mesh
/// resolves.
bool nearly_sphere(const Points& points, const Vector3& center);

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
