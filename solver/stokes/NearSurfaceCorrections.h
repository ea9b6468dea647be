#pragma once
// A layer near its surface at the vertices of other surfaces: what a rule made for each of these
// gives less what the regular rule does. A sparse matrix.

#include "solver/stokes/LayerRules.h"
#include "solver/stokes/SurfacePanels.h"

#include <algorithm>
#include <optional>

namespace vesicle
{

struct LayerPoints;
struct LayerSurface;

/// The vertices of other surfaces that are near one, by their numbers among all, ascending, and the
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

/// Of each surface. Threads share the surfaces.
std::vector<NearVertices> near_vertices(const std::vector<LayerSurface>& surfaces);

enum class LayerKernel
{
  stokeslet, ///< G/8πμ, μ = 1
  stresslet  ///< X X (X·n)/8π r⁵ (DoubleLayer.h)
};

/// Between the nodes of one surface and the vertices near it, at one shape.
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
    const Surface& surface, const Points& vertices, const NearVertices& near, LayerKernel kernel);

  /// To the velocities at all vertices what f = Σ N_k f_k adds. Threads share the vertices; results
  /// do not depend on their number.
  void add(const Eigen::VectorXd& density, Points& velocity) const;

  /// visit(node, block) for a vertex by its number among all; the block's xx, xy, xz, yy, yz, zz.
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
  void fill(const Surface& surface, const NearVertices& near, LayerKernel kernel, int row,
    const Vector3& x);

  std::vector<int> vertex_, node_;
  std::vector<std::size_t> start_{ 0 }; ///< of each vertex, in the nodes
  std::vector<double> blocks_;          ///< of each node in the list
};

}
