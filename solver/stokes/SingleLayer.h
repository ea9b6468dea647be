#pragma once
// The single layer of the Stokeslet, collocated at the vertices: u(x_i) = (1/8πμ) ∮ G(x_i, y) f(y)
// dS(y), G = I/r + X Xᵀ/r³, paper (11)–(13) with μ = 1, as matrices from nodal unknowns of the
// force density f.

#include "solver/mesh/Connectivity.h"
#include "solver/surface/SurfaceIntegrals.h"

#include <vector>

namespace vesicle
{

struct StokesletSources;

/// Row-major; rows (and columns, where they are components) have 3 entries a node.
using DenseMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Velocity at the vertices from a normal force density φ and from a tension γ, both nodal.
struct VelocityResponse
{
  DenseMatrix normal;   ///< 3N by N, or empty
  DenseMatrix tension;  ///< 3N by N, or empty
  Eigen::VectorXd load; ///< 3N: velocity that the given load makes, or empty

  /// u = normal φ + tension γ; empty arguments are left out.
  Eigen::VectorXd velocity(const Eigen::VectorXd& phi, const Eigen::VectorXd& gamma) const;
};

/// Quadrature of the layer. Elements that touch the target use a Duffy rule around the corner,
/// whose radial part is exact with one point on flat elements; the others use triangle rules. The
/// error of a rule on an element next to those that touch, one edge length from the target, falls
/// with h only as the element's share of the velocity does, so a surface of higher order needs a
/// finer one there.
struct LayerQuadrature
{
  int regular = 3; ///< points a triangle: 1, 3, 6 or 12
  int near = 0;    ///< points a triangle that shares a corner with those that touch; 0: as regular
  int graded = 0;  ///< levels of refinement of elements towards extraordinary vertices
  int radial = 1;  ///< Duffy points from the corner outwards
  int angular = 4; ///< Duffy points along the opposite edge
};

/// Quadrature for a smooth surface around a regular rule: the next finer one near the target and
/// Duffy rules to match. On the unit sphere of 320, 1,280 and 5,120 triangles (Loop) the velocity
/// of a constant density is off, root mean square, by 1.3e-4, 1.9e-5 and 4.6e-6 with three points,
/// 1.0e-4, 1.3e-5 and 1.7e-6 with six; the surface itself, which passes through the sphere at its
/// vertices only, leaves 1.0e-4, 1.3e-5 and 1.4e-6.
LayerQuadrature smooth_layer_quadrature(int regular);

class SingleLayer
{
public:
  SingleLayer(const Basis& basis, const LayerQuadrature& quadrature);

  const BasisTable& table() const { return regular_; }

  /// The whole matrix for a nodal vector density f = Σ N_k f_k: 3N by 3N. `vertices` are the
  /// collocation points, `control` the control points (the same for linear elements). Threads share
  /// the rows, here and below; results do not depend on their number.
  void assemble(const Points& vertices, const Points& control, DenseMatrix& matrix) const;

  /// Response to f = Σ N_k (n_k φ_k + (T γ)_k) with nodal normals n and a sparse T (3N by N, or
  /// empty) that gives the tension force's density; `load` is a nodal vector density (3N, or
  /// empty).
  void respond(const Points& points, const Points& normal, bool with_normal, const SparseMatrix& T,
    const Eigen::VectorXd& load, VelocityResponse& response) const;

  /// Response to f = Σ N_k φ_k n + Σ γ_k (∇_s N_k − 2 H N_k n) with the surface's own normal and
  /// mean curvature: the tension force density itself, for bases with second derivatives. `load` is
  /// a nodal normal density (N, or empty).
  void respond_on_surface(const Points& vertices, const Points& control, bool with_normal,
    bool with_tension, const Eigen::VectorXd& load, VelocityResponse& response) const;

private:
  template<class Sources, class Kernel, class Write>
  void for_each_block(const Points& vertices, const Sources& regular, const Sources& near,
    const Sources& singular, Kernel kernel, Write write) const;

  BasisTable regular_;
  BasisTable near_;                 ///< rows of the finer rule, or none
  BasisTable singular_;             ///< Duffy rows, grouped by vertex
  std::vector<int> regular_start_;  ///< first regular row of each element
  std::vector<int> near_start_;     ///< first near row of each element
  std::vector<int> singular_start_; ///< first Duffy row of each vertex
  AdjacencyList vertex_elements_;   ///< elements that touch each vertex
  AdjacencyList near_elements_;     ///< those that share a corner with them, or none
  std::vector<int> order_;          ///< targets so that those of a block are neighbours
};

/// y = A x with A row-major; rows in parallel, each summed in a fixed order. Adds to y if `add`.
void multiply(const DenseMatrix& A, const Eigen::VectorXd& x, Eigen::VectorXd& y, bool add = false);

}
