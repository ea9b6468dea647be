#pragma once
// The quadrature of the single layer collocated at a mesh's vertices: rules on all elements, and
// their sparse corrections near and at the targets. Made once for all shapes of a mesh.

#include "solver/mesh/Connectivity.h"
#include "solver/mesh/TriangleMesh.h"
#include "solver/stokes/PanelBasis.h"
#include "solver/surface/Basis.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace vesicle
{

/// Elements that touch the target use a Duffy rule around the corner, whose radial part is exact
/// with one point on flat elements; the others use triangle rules. The error of a rule on an
/// element next to those that touch, one edge length from the target, falls with h only as the
/// element's share of the velocity does, so a surface of higher order needs a finer one there.
struct LayerQuadrature
{
  int regular = 3; ///< points a triangle: 1, 3, 6 or 12
  int near = 0;    ///< points a triangle that shares a corner with those that touch; 0: as regular
  int graded = 0;  ///< levels of refinement of elements towards extraordinary vertices
  int radial = 1;  ///< Duffy points from the corner outwards
  int angular = 4; ///< Duffy points along the opposite edge
};

/// Around a regular rule: for flat elements that alone and Duffy's; for a smooth surface the next
/// finer one near the target and Duffy rules to match. On the unit sphere of 320, 1,280 and 5,120
/// triangles (Loop) the velocity of a constant density is off, root mean square, by 1.3e-4, 1.9e-5
/// and 4.6e-6 with three points, 1.0e-4, 1.3e-5 and 1.7e-6 with six; the surface itself, which
/// passes through the sphere at its vertices only, leaves 1.0e-4, 1.3e-5 and 1.4e-6.
LayerQuadrature layer_quadrature(const Basis& basis, int regular);

class LayerRules
{
public:
  /// Where there are several surfaces the basis must outlive the rules.
  LayerRules(const Basis& basis, const LayerQuadrature& quadrature);

  /// Points of a rule; those of item i (element or vertex) are rows start[i] to start[i + 1].
  struct Rule
  {
    BasisTable table;
    std::vector<int> start;
  };
  const Rule& regular() const { return regular_; }   ///< by element
  const Rule& near() const { return near_; }         ///< by element, or no rows
  const Rule& singular() const { return singular_; } ///< Duffy points, by vertex

  int vertices() const { return static_cast<int>(touching_.start.size()) - 1; }
  /// Elements that touch each vertex: singular instead of regular.
  const AdjacencyList& touching() const { return touching_; }
  /// Those that share a corner with them: near instead of regular; or none.
  const AdjacencyList& close() const { return close_; }
  /// Up to stokeslet_lanes vertices whose sums are made at once, a lane each: neighbours, so that few
  /// elements are special.
  struct Group
  {
    std::vector<int> target;
    /// An element that touches a target or is next to one; bits: the lanes that it touches, is next to.
    struct Special
    {
      int element;
      std::uint8_t touching, close;
    };
    std::vector<Special> special; ///< by element
    std::vector<int> nodes;       ///< that these elements feel, ascending
  };
  const std::vector<Group>& groups() const { return groups_; }

  /// What rules for targets near the surface are made of, on another one (NearSurfaceCorrections.h).
  const PanelBasis& panels() const { return panels_->get(); }

private:
  Group group_of(std::vector<int> targets) const;

  Rule regular_, near_, singular_;
  AdjacencyList touching_, close_;
  std::vector<Group> groups_;
  std::unique_ptr<const LazyPanelBasis> panels_;
};

}
