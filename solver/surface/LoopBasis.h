#pragma once
// Loop's subdivision surface as a basis: C² but for the extraordinary vertices (valence other than
// six), where it is C¹ with square-integrable curvature. Loop (M.S. thesis, Utah 1987); exact
// evaluation after Stam (SIGGRAPH '98 course notes, "Evaluation of Loop subdivision surfaces"), by
// recursion to a regular leaf instead of eigenvectors.

#include "solver/mesh/Connectivity.h"
#include "solver/surface/Basis.h"

namespace vesicle
{

class LoopBasis final : public Basis
{
public:
  /// For integrals over the surface: six points an element, and elements at extraordinary vertices
  /// halved three times towards them, which costs little. An energy of fewer points lets the surface
  /// ripple between them where it is hardly resolved.
  static constexpr int rule_points = 6, rule_grading = 3;

  /// A closed manifold mesh with valences of at least 3. Throws InputError.
  LoopBasis(Triangles triangles, int nodes);

  int nodes() const override { return nodes_; }
  const Triangles& elements() const override { return triangles_; }
  bool smooth() const override { return true; }
  /// 12 entries a row on elements whose corners all have valence six; n₀ + n₁ + n₂ − 6 in general.
  /// Second derivatives are included. Points must not be corners of extraordinary vertices.
  BasisTable tabulate(std::span<const ParametricPoint> points) const override;
  SparseMatrix collocation() const override;
  Eigen::VectorXd collocation_scale() const override;
  /// −log₂ λ with λ = 3/8 + cos(2π/n)/4, by which a level of subdivision shrinks the neighbourhood
  /// of a vertex of valence n.
  double radial_exponent(int vertex) const override;
  Points vertex_normals(const Points& control) const override;

protected:
  std::array<bool, 3> rough_corners(int element) const override;

private:
  struct Patch;
  Patch patch(int element) const;

  Triangles triangles_;
  int nodes_;
  AdjacencyList ring_; ///< neighbours of each vertex, counter-clockwise
};

/// Weight of each neighbour in Loop's rule for an old vertex of valence n; the vertex itself keeps
/// 1 − nβ.
double loop_vertex_weight(int valence);

}
