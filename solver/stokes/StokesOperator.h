#pragma once
// The single layer of the Stokeslet, collocated at the vertices of one or several surfaces:
// u(x_i) = (1/8πμ) ∮ G(x_i, y) f(y) dS(y), G = I/r + X Xᵀ/r³, X = y − x_i, paper (11)–(13), with
// μ = 1. Anywhere else: FlowField.h.

#include "solver/stokes/ForceDensity.h"
#include "solver/stokes/LayerCorrections.h"
#include "solver/stokes/LayerRules.h"
#include "solver/stokes/NearSurfaceCorrections.h"
#include "solver/stokes/PointSum.h"

#include <span>
#include <vector>

namespace vesicle
{

/// Row-major; rows (and columns, where they are components) have 3 entries a node.
using DenseMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A surface at one moment. `rules` must outlive the operator.
struct LayerSurface
{
  const LayerRules* rules;
  Points vertices, control; ///< collocation points and control points: the same on flat triangles
};

/// Force densities that numbers at the nodes stand for, one column of the operator each.
///
/// f = Σ N_k (F y)_k: the vectors F y at the nodes, F 3N by m. The three rows of a node have the
/// same columns.
struct NodalDensities
{
  const SparseMatrix& F;
};
/// Points of a rule at a shape; weight contains dS/8πμ.
struct LayerPoints
{
  SurfacePoints surface;
  Eigen::VectorXd weight;
  LayerPoints(const BasisTable& table, const Points& control);
};

/// What finer rules add to a surface's regular one.
struct SurfaceCorrections
{
  LayerCorrections own;                       ///< at its own vertices
  std::optional<NearSurfaceCorrections> near; ///< at other surfaces' vertices, where there are any

  /// To all velocities what the vectors at the nodes make; `first_vertex`: of the surface's own.
  void add(const Eigen::VectorXd& nodal, int first_vertex, Points& velocities) const
  {
    own.add(nodal, first_vertex, velocities);
    if (near)
      near->add(nodal, velocities);
  }
};

struct StokesletSources;
template<class Sources>
struct RuleSources;

/// Sets the geometry once; then densities are applied as often as wanted. Rows are the vertices of
/// all surfaces, one after the other. Threads share the rows; results do not depend on their
/// number.
class StokesOperator
{
public:
  explicit StokesOperator(std::vector<LayerSurface> surfaces);

  /// All vertices.
  int vertices() const { return first_.back(); }

  /// The velocities that force densities make, one for each surface: 3N. The direct sum over the
  /// regular rules of all surfaces, then the corrections near and at each surface's own vertices. There
  /// are none for surfaces near each other: their densities have to be nodal.
  Eigen::VectorXd apply(std::span<const ForceDensity> densities) const;

  /// The velocities that each density of surface `source` makes at all vertices: 3N by their
  /// number.
  DenseMatrix columns(int source, const NodalDensities& densities) const;
  /// Of all vectors at its nodes, f = Σ N_k f_k: 3N by 3N.
  DenseMatrix matrix(int source) const;

  /// Of the single layer, or of the double layer, whose kernel is X X (X·n)/8π r⁵ here (DoubleLayer.h):
  /// forces or stresslets.
  SurfaceCorrections corrections(int source, PointKind kind) const;
  int surfaces() const { return static_cast<int>(surfaces_.size()); }
  const LayerSurface& surface(int source) const { return surfaces_[source]; }
  int first_vertex(int source) const { return first_[source]; }
  const LayerPoints& regular_points(int source) const { return regular_[source]; }
  /// The points of all surfaces' regular rules and the vertices of all.
  PointPlaces places() const;
  /// These alone, N by 3.
  const Points& targets() const { return targets_; }

private:
  /// Made when they are needed: of many surfaces they would take more memory than all else.
  struct FinePoints
  {
    LayerPoints near, singular;
  };
  FinePoints fine_points(int source) const;
  RuleSources<StokesletSources> node_sources(int source, const FinePoints& fine) const;
  NearSurfaceCorrections near_surface_corrections(
    int source, PointKind kind, const LayerPoints& near) const;
  LayerCorrections double_layer_corrections(int source, const FinePoints& fine) const;
  template<class Write>
  void for_each_group(int source, Write write) const;
  template<class Sources, class Add>
  LayerCorrections corrections(int source, const RuleSources<Sources>& sources, Add add) const;

  std::vector<LayerSurface> surfaces_;
  Points targets_;
  std::vector<LayerPoints> regular_; ///< of each surface
  std::vector<int> first_;           ///< first vertex of each surface, and the number of all
  std::vector<NearVertices> near_;   ///< of each surface where there are several
};

/// y = A(:, first:) x over x.size() columns; rows in parallel, each summed in a fixed order.
Eigen::VectorXd multiply(const DenseMatrix& A, const Eigen::VectorXd& x, Eigen::Index first = 0);

}
