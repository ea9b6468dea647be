#pragma once
// The basis of the surface: x(u, v) = Σ N_k(u, v) x_k over the nodes k that an element feels.
// Everything that integrates over the surface is written against a table of N_k and its derivatives
// at quadrature points, so that linear elements and smoother ones share one set of operators.

#include "solver/surface/Quadrature.h"
#include "solver/mesh/TriangleMesh.h"

#include <Eigen/SparseCore>

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace vesicle
{

using SparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

class ElementPattern;

/// Rows are quadrature points; the entries of row q are those from start[q] to start[q + 1].
struct BasisTable
{
  int nodes = 0;
  std::vector<int> element;   ///< of each row
  std::vector<double> weight; ///< parametric weight of each row
  std::vector<int> start{ 0 };
  std::vector<int> node;             ///< of each entry
  std::vector<double> value, du, dv; ///< N_k, ∂N_k/∂u, ∂N_k/∂v of each entry
  std::vector<double> duu, duv, dvv; ///< second derivatives; empty for linear elements
  /// Of matrices over the nodes; none: made each time.
  std::shared_ptr<const ElementPattern> pattern;

  int rows() const { return static_cast<int>(weight.size()); }
};

/// Three numbers of every entry of a table.
using EntryVectors = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// Calls visit(first row, end row, nodes) for each element: its rows are consecutive and have the
/// same nodes in the same order, so that products of entries can be added up before they are
/// sorted.
template<class Visit>
void for_each_element(const BasisTable& table, Visit visit)
{
  for (int q = 0, last; q < table.rows(); q = last)
  {
    for (last = q + 1; last < table.rows() && table.element[last] == table.element[q];)
      ++last;
    visit(
      q, last, std::span(table.node).subspan(table.start[q], table.start[q + 1] - table.start[q]));
  }
}

class Basis
{
public:
  virtual ~Basis() = default;
  virtual int nodes() const = 0;
  virtual const Triangles& elements() const = 0;
  /// True where there are second derivatives and the vertices' positions aren't the nodes'.
  virtual bool smooth() const = 0;
  /// One row a point, in the order given.
  virtual BasisTable tabulate(std::span<const ParametricPoint> points) const = 0;
  /// The triangle rule on every element, element by element; elements at extraordinary vertices,
  /// where the parametrisation isn't smooth, are halved `graded` times towards them.
  std::vector<ParametricPoint> rule(std::span<const TrianglePoint> rule, int graded) const;
  /// On the elements first to last − 1.
  std::vector<ParametricPoint> rule(
    std::span<const TrianglePoint> rule, int graded, int first, int last) const;
  /// P: surface points at the mesh's vertices = P · control points. Velocities are collocated
  /// there.
  virtual SparseMatrix collocation() const = 0;
  /// Factors of P's rows that leave a symmetric matrix: P = diag(scale) S.
  virtual Eigen::VectorXd collocation_scale() const = 0;
  /// Distances from a vertex grow as its parametric distance to that power; 1 where the
  /// parametrisation is smooth.
  virtual double radial_exponent(int vertex) const = 0;
  /// Unit outward normals at the vertices: N by 3.
  virtual Points vertex_normals(const Points& control) const = 0;

protected:
  /// Corners where an element's parametrisation isn't smooth.
  virtual std::array<bool, 3> rough_corners(int element) const = 0;
};

/// Flat triangles: the three corners' barycentric coordinates.
class LinearBasis final : public Basis
{
public:
  LinearBasis(Triangles triangles, int nodes);
  int nodes() const override { return nodes_; }
  const Triangles& elements() const override { return triangles_; }
  bool smooth() const override { return false; }
  BasisTable tabulate(std::span<const ParametricPoint> points) const override;
  SparseMatrix collocation() const override;
  Eigen::VectorXd collocation_scale() const override { return Eigen::VectorXd::Ones(nodes_); }
  double radial_exponent(int) const override { return 1; }
  Points vertex_normals(const Points& control) const override;

protected:
  std::array<bool, 3> rough_corners(int) const override { return {}; }

private:
  Triangles triangles_;
  int nodes_;
};

/// The triangle rule on every element.
BasisTable tabulate_rule(const Basis& basis, std::span<const TrianglePoint> rule, int graded = 0);

}
