#pragma once
// Which of many spheres hold a point: the search for panels and elements near a target.

#include "solver/mesh/Connectivity.h"
#include "solver/mesh/TriangleMesh.h"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace vesicle
{

/// Spheres sorted into cells as wide as the largest of them.
class SpheresAround
{
public:
  SpheresAround(std::vector<Vector3> centers, std::vector<double> radii);

  /// The numbers of those that hold x, ascending, into `found`.
  void find(const Vector3& x, std::vector<int>& found) const;
  /// Of each point. Threads share the points.
  AdjacencyList of(const Points& points) const;

private:
  using Cell = std::array<std::int64_t, 3>;
  Cell cell(const Vector3& x) const;

  std::vector<Vector3> centers_;
  std::vector<double> radii_;
  double width_ = 0;
  std::vector<std::pair<Cell, int>> sorted_; ///< each sphere by its centre's cell
};

}
