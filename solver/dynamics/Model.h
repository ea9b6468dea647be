#pragma once
// What the scene asks for, dimensionless, and the operators that follow from it at one shape. A
// term that the scene doesn't have is empty here and costs nothing further on.

#include "solver/geometry/Basis.h"
#include "solver/membrane/Bending.h"
#include "solver/scene/Scene.h"
#include "solver/stokes/StokesletMatrix.h"

#include <optional>

namespace vesicle
{

/// The scene in units of r0, EB and μ.
struct Model
{
  bool bending = false;
  bool incompressible = true;
  double bond = 0;                 ///< Δρ g r0⁴/EB; 0: no buoyancy
  std::optional<Scene::Flow> flow; ///< dimensionless
  Scene::Scheme scheme = Scene::Scheme::robust;

  bool robust() const { return scheme == Scene::Scheme::robust; }
};

/// Everything about one shape. Vectors over the nodes' components have 3N entries, interleaved.
/// Densities are forces an area, the membrane's on the fluid.
struct ShapeOperators
{
  ShapeOperators(const Model& model, const StokesletMatrix& stokeslets, const Points& points,
    const Triangles& triangles);

  SurfacePoints surface; ///< at the rows of the Stokeslet table
  CotanGeometry cotan;
  Curvature curvature;
  Eigen::VectorXd vertex_area;
  Eigen::VectorXd volume_gradient; ///< ∂V/∂x
  SparseMatrix area_rate;          ///< B
  double area, volume;
  Vector3 center;                                             ///< centroid of the volume
  Points outward;                                             ///< ∂V/∂x normalised at each node
  Eigen::Matrix<double, 3, Eigen::Dynamic> centroid_velocity; ///< W: U = W u

  Points normal;                 ///< direction of the bending force; outward in the robust scheme
  Eigen::VectorXd bending;       ///< φ = f_b·n at this shape: N, or empty
  SparseMatrix bending_response; ///< R, δφ = R δx: N by 3N, or empty
  SparseMatrix tension_force;    ///< T, density T γ: 3N by N, or empty
  SparseMatrix divergence;       ///< constraint on the velocity: N by 3N, or empty
  Eigen::VectorXd load;          ///< density of gravity: 3N, or empty
  Eigen::VectorXd ambient;       ///< u∞: 3N, or empty

  /// True where the shape is so close to a sphere that a uniform tension does no work: then the
  /// total area follows from the volume, and the gauge of the tension is fixed to a zero mean.
  bool gauge_pinned = false;
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

}
