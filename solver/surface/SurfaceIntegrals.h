#pragma once
// The surface at the rows of a basis table, and the functionals of the surface with their exact
// derivatives. Vectors over the nodes have 3 entries a node (x, y, z interleaved), 3N in all.

#include "solver/surface/Basis.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace vesicle
{

/// #rows by 3, one component a column: structure of arrays.
using RowVectors = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// Position, tangents a_u = ∂x/∂u, a_v = ∂x/∂v and their cross product at the rows of a table. The
/// area element is dS = |a_u × a_v| du dv; n = a_u × a_v/|a_u × a_v| points outward.
struct SurfacePoints
{
  RowVectors position, tangent_u, tangent_v, cross;
  Eigen::VectorXd area_weight; ///< weight · |a_u × a_v|: the rows' share of the area
};
SurfacePoints evaluate(const BasisTable& table, const Points& nodes);

/// Σ N_k f_k at the rows, of a nodal scalar or vector field: #rows by 1 or 3.
Eigen::VectorXd interpolate(const BasisTable& table, const Eigen::VectorXd& nodal);
RowVectors interpolate(const BasisTable& table, const Points& nodal);
/// The same at one row.
Eigen::RowVector3d interpolate(const BasisTable& table, int row, const Points& nodal);

/// ∂²x/∂u², ∂²x/∂u∂v, ∂²x/∂v² at the rows, for bases with second derivatives.
struct SecondDerivatives
{
  RowVectors uu, uv, vv;
};
SecondDerivatives second_derivatives(const BasisTable& table, const Points& nodes);

/// H = −½ a^{αβ} ∂²x/∂α∂β · n at the rows, for bases with second derivatives; +1/R on a sphere.
Eigen::VectorXd mean_curvature(
  const BasisTable& table, const SurfacePoints& surface, const Points& nodes);
Eigen::VectorXd mean_curvature(const SurfacePoints& surface, const SecondDerivatives& second);

double area(const SurfacePoints& surface);
/// Enclosed volume, (1/3) ∮ x·n dS, with x taken from the area's centroid.
double volume(const BasisTable& table, const SurfacePoints& surface);
/// Centroid of the enclosed volume, (1/2V) ∮ |x|² n dS.
Vector3 centroid(const BasisTable& table, const SurfacePoints& surface);

/// A_k = ∮ N_k dS: N.
Eigen::VectorXd vertex_areas(const BasisTable& table, const SurfacePoints& surface);
/// B: N by 3N, (B u)_k = dA_k/dt = ∮ N_k ∇_s·u dS when the nodes move with u. Exact derivative of
/// vertex_areas; A⁻¹B is the paper's D, (28)–(31). Its transpose gives the tension's nodal forces
/// −Bᵀγ.
SparseMatrix area_rate_matrix(const BasisTable& table, const SurfacePoints& surface);
/// ∂A/∂x = 1ᵀB: 3N.
Eigen::VectorXd area_gradient(const BasisTable& table, const SurfacePoints& surface);
/// ∂V/∂x: 3N. The nodes' area-weighted normals, ∮ N_k n dS.
Eigen::VectorXd volume_gradient(const BasisTable& table, const SurfacePoints& surface);
/// Galerkin load of a normal force density p(x) n, F_k = ∮ N_k p n dS: 3N; `density` has one entry
/// a row.
Eigen::VectorXd normal_load(
  const BasisTable& table, const SurfacePoints& surface, const Eigen::VectorXd& density);
/// Velocity of the volume's centroid, (1/V) ∮ (x − x_c) u·n dS, as a 3 by 3N matrix acting on u.
Eigen::Matrix<double, 3, Eigen::Dynamic> centroid_velocity_matrix(
  const BasisTable& table, const SurfacePoints& surface);
/// ∂V/∂x normalised at every node: N by 3 unit vectors.
Points area_weighted_normals(const Eigen::VectorXd& volume_gradient);

}
