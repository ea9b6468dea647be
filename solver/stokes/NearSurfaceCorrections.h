#pragma once
// A layer near its surface at vertices beside it: what a rule made for each of these gives less what
// the regular rule does. A sparse matrix.

#include "solver/stokes/LayerRules.h"
#include "solver/stokes/SurfacePanels.h"
#include "solver/stokes/kernels/StokesletKernel.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <optional>

namespace vesicle
{

struct LayerPoints;
struct LayerSurface;

/// The vertices that are near a surface and not its own, by their numbers among all, ascending, and the
/// elements that each of them is near to.
///
/// Elements farther from a vertex than about their own size have the near rule that vertices of the
/// surface itself have next to them. The others are integrated panel by panel as in FlowField.h, with a
/// rule for the vertex that holds at any distance.
struct NearVertices
{
  std::vector<int> vertex;
  AdjacencyList elements;
  std::optional<SurfacePanels> panels; ///< the surface's; none where no vertex is near
};

/// Vertices that may be near, numbered from `first`, and the box around them.
struct VertexGroup
{
  int first;
  const Points* vertices;
  Eigen::AlignedBox3d box;
};
NearVertices near_vertices(
  const LayerRules& rules, const Points& control, const std::vector<VertexGroup>& others);
/// Of each surface to the others' vertices. Threads share the surfaces.
std::vector<NearVertices> near_vertices(const std::vector<LayerSurface>& surfaces);

/// Between the nodes of one surface and the vertices near it, at one shape. Kernels are those of the
/// kinds of points over 8πμ, μ = 1, stresslets with X X (X·n)/r⁵ (DoubleLayer.h). For images the
/// surface is the mirrored one, in the wall's frame (WallImages.h).
class NearSurfaceCorrections
{
public:
  struct Surface
  {
    const LayerRules& rules;
    const LayerPoints &regular, &near; ///< points of these rules
  };
  /// `vertices`: all.
  NearSurfaceCorrections(
    const Surface& surface, const Points& vertices, const NearVertices& near, PointKind kind);

  /// To the velocities at all vertices what f = Σ N_k f_k adds. Threads share the vertices; results
  /// do not depend on their number.
  void add(const Eigen::VectorXd& density, Points& velocity) const;

  /// visit(node, block) for a vertex by its number among all; the block's xx, xy, xz, yy, yz, zz. Not of
  /// images.
  template<class Visit>
  void for_each_node(int vertex, Visit visit) const
  {
    const auto at = std::lower_bound(vertex_.begin(), vertex_.end(), vertex);
    if (at == vertex_.end() || *at != vertex)
      return;
    const auto row = at - vertex_.begin();
    for (std::size_t k = start_[row]; k < start_[row + 1]; ++k)
      visit(node_[k], blocks_.data() + 6 * k);
  }

private:
  template<int size>
  void fill(
    const Surface& surface, const NearVertices& near, PointKind kind, int row, const Vector3& x);

  int block_size_; ///< numbers a block: 6 of a symmetric one, or 9, its rows
  std::vector<int> vertex_, node_;
  std::vector<std::size_t> start_{ 0 }; ///< of each vertex, in the nodes
  std::vector<double> blocks_;          ///< of each node in the list
};

}
