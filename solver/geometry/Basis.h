#pragma once
// The basis of the surface: x(u, v) = Σ N_k(u, v) x_k over the nodes k that an element feels.
// Everything that integrates over the surface is written against a table of N_k and its derivatives
// at quadrature points, so that linear elements and smoother ones share one set of operators.

#include "solver/geometry/Quadrature.h"
#include "solver/mesh/TriangleMesh.h"

#include <span>
#include <vector>

namespace vesicle
{

/// Rows are quadrature points; the entries of row q are those from start[q] to start[q + 1].
struct BasisTable
{
  int nodes = 0;
  std::vector<int> element;   ///< of each row
  std::vector<double> weight; ///< parametric weight of each row
  std::vector<int> start{ 0 };
  std::vector<int> node;             ///< of each entry
  std::vector<double> value, du, dv; ///< N_k, ∂N_k/∂u, ∂N_k/∂v of each entry

  int rows() const { return static_cast<int>(weight.size()); }
};

class Basis
{
public:
  virtual ~Basis() = default;
  virtual int nodes() const = 0;
  virtual const Triangles& elements() const = 0;
  /// One row a point, in the order given.
  virtual BasisTable tabulate(std::span<const ParametricPoint> points) const = 0;
};

/// Flat triangles: the three corners' barycentric coordinates.
class LinearBasis final : public Basis
{
public:
  LinearBasis(Triangles triangles, int nodes);
  int nodes() const override { return nodes_; }
  const Triangles& elements() const override { return triangles_; }
  BasisTable tabulate(std::span<const ParametricPoint> points) const override;

private:
  Triangles triangles_;
  int nodes_;
};

/// The same triangle rule on every element, element by element.
BasisTable tabulate_rule(const Basis& basis, std::span<const TrianglePoint> rule);

}
