#pragma once
// Where vesicles are near each other: distances from the vertices of each to the others' surfaces, and
// the smallest gap.

#include "solver/mesh/TriangleTree.h"
#include "solver/stokes/LayerRules.h"
#include "solver/stokes/SurfacePanels.h"
#include "solver/surface/Surface.h"

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vesicle
{

/// Between two vesicles; below 0 they cross.
struct Gap
{
  double distance = std::numeric_limits<double>::infinity();
  std::array<std::size_t, 2> vesicle{};
  std::array<Vector3, 2> place{ Vector3::Zero(), Vector3::Zero() }; ///< on each
};
/// "vesicles 0 and 1 are 0.01 apart near (0, 0, 1)", or that they cross.
std::string to_text(const Gap& gap);

class Proximity
{
public:
  struct Side
  {
    const LayerRules* rules;
    const Surface* surface;
  };
  /// Vertices within `reach` of another vesicle's surface are found; what is farther costs a
  /// comparison of boxes. Rules and surfaces must outlive it. Threads share the vesicles; results do
  /// not depend on their number.
  Proximity(std::vector<Side> sides, double reach);

  /// The point of a surface that is nearest to x.
  struct Place
  {
    int panel = -1; ///< of the rules' PanelBasis
    double u = 0, v = 0;
    Vector3 position, normal;                                  ///< outward
    double distance = std::numeric_limits<double>::infinity(); ///< of x; below 0 inside
    int triangle = -1;                                         ///< of the mesh, near the place
    Vector3 weights; ///< of its corners, about those of the place
  };
  struct NearVertex
  {
    std::size_t vesicle;
    int vertex;
    std::size_t other;
    Place place; ///< on the other
  };
  /// By vesicle, other vesicle, vertex.
  const std::vector<NearVertex>& near() const { return near_; }
  std::size_t sides() const { return sides_.size(); }
  const Side& side(std::size_t vesicle) const { return sides_[vesicle]; }
  /// The smallest within reach: between the surfaces, not their vertices alone.
  std::optional<Gap> smallest() const;

private:
  struct Searched
  {
    TriangleTree tree;
    SurfacePanels panels;
  };
  std::vector<NearVertex> near_vertices(std::size_t vesicle, std::size_t other, double reach) const;
  Place nearest(std::size_t vesicle, const Vector3& x) const;
  Gap between(const NearVertex& from) const;

  std::vector<Side> sides_;
  std::vector<std::unique_ptr<const Searched>> searched_; ///< of vesicles near another
  std::vector<NearVertex> near_;
};

/// Of each vesicle the distance to the nearest other one, by the vertices of both; infinite where none is
/// within reach.
std::vector<double> distances(const Proximity& proximity);

}
