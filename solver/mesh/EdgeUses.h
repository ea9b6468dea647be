#pragma once
// The sides of all triangles, sorted so that the sides on one edge stand together: the one list
// from which neighbours, borders and orientation are read off.

#include "solver/mesh/TriangleMesh.h"

#include <array>
#include <span>
#include <vector>

namespace vesicle
{

/// One side of one triangle: an edge between the points a < b, run from a to b if `forward`.
struct EdgeUse
{
  int a;
  int b;
  int triangle;
  bool forward;
};

class EdgeUses
{
public:
  explicit EdgeUses(const Triangles& triangles);

  /// Number of edges, in ascending order of (a, b).
  int size() const { return static_cast<int>(start_.size()) - 1; }
  /// The number of the edge between two points, in any order, which must be there.
  int find(int a, int b) const;
  /// The sides on edge e, by ascending triangle. A side from a point to itself is no edge.
  std::span<const EdgeUse> operator[](int e) const
  {
    return { uses_.data() + start_[e], uses_.data() + start_[e + 1] };
  }

private:
  std::vector<EdgeUse> uses_;
  std::vector<int> start_;
};

/// Of a closed manifold mesh: the triangle over the edge opposite to each corner of each triangle.
std::vector<std::array<int, 3>> triangles_across(const Triangles& triangles);

}
