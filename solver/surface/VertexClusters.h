#pragma once
// Vertices in groups of near ones, whose neighbourhoods are found together.

#include "solver/mesh/Connectivity.h"
#include "solver/mesh/TriangleMesh.h"

#include <span>
#include <vector>

namespace vesicle
{

/// Each vertex is in one cluster: those within `radius` of the cluster's first vertex that are
/// connected to it through others of the cluster and were in none before, at most a few hundred.
class VertexClusters
{
public:
  VertexClusters(const Points& points, const AdjacencyList& neighbours, double radius);

  int size() const { return static_cast<int>(start_.size()) - 1; }
  std::span<const int> operator[](int cluster) const
  {
    return std::span(member_).subspan(
      start_[cluster], static_cast<std::size_t>(start_[cluster + 1]) - start_[cluster]);
  }

private:
  std::vector<int> start_{ 0 };
  std::vector<int> member_;
};

}
