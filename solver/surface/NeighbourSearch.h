#pragma once
// The vertices around a vertex, found along the edges of the mesh.

#include "solver/mesh/Connectivity.h"

#include <vector>

namespace vesicle
{

/// One search after the other; keeps its memory.
class NeighbourSearch
{
public:
  /// From a vertex of a mesh of `count`, which is seen, but not among those found.
  void begin(int vertex, int count)
  {
    if (++search_ == 0 || static_cast<int>(seen_.size()) != count)
    {
      seen_.assign(count, 0);
      search_ = 1;
    }
    seen_[vertex] = search_;
    found_.clear();
  }

  /// Adds those neighbours of `vertex` that weren't seen and that accept(neighbour) takes.
  template<typename Accept>
  void visit(const AdjacencyList& neighbours, int vertex, const Accept& accept)
  {
    for (const int* j = neighbours.begin(vertex); j != neighbours.end(vertex); ++j)
    {
      if (seen_[*j] == search_)
        continue;
      seen_[*j] = search_;
      if (accept(*j))
        found_.push_back(*j);
    }
  }

  /// All that can be reached from a vertex through others that accept() takes.
  template<typename Accept>
  void spread(const AdjacencyList& neighbours, int vertex, const Accept& accept)
  {
    begin(vertex, static_cast<int>(neighbours.start.size()) - 1);
    visit(neighbours, vertex, accept);
    for (std::size_t k = 0; k < found_.size(); ++k) // NOLINT(modernize-loop-convert): it grows
      visit(neighbours, found_[k], accept);
  }

  /// In the order in which they were found: ring by ring.
  const std::vector<int>& found() const { return found_; }
  std::size_t size() const { return found_.size(); }

private:
  std::vector<unsigned> seen_; ///< of each vertex: the last search that came by
  unsigned search_ = 0;
  std::vector<int> found_;
};

}
