#pragma once
// Edges and neighbours, which follow from the triangles alone.

#include "solver/mesh/TriangleMesh.h"

#include <array>
#include <vector>

namespace vesicle
{

/// Compressed lists: the entries of list i are item[start[i]] … item[start[i + 1] − 1].
struct AdjacencyList
{
  std::vector<int> start;
  std::vector<int> item;

  const int* begin(int i) const { return item.data() + start[i]; }
  const int* end(int i) const { return item.data() + start[i + 1]; }
  int size(int i) const { return start[i + 1] - start[i]; }
};

/// What the triangles alone say, for any triangle mesh (also open or non-manifold ones).
struct Connectivity
{
  Connectivity(const Triangles& triangles, int points);

  /// Every edge once, as (smaller, larger) vertex, sorted.
  std::vector<std::array<int, 2>> edges;
  /// Triangles around each vertex, ascending.
  AdjacencyList vertex_triangles;
  /// Neighbours of each vertex along edges, ascending.
  AdjacencyList vertex_neighbours;
  /// Number of triangles at each edge: 1 on an open border, 2 inside, more where it isn't a
  /// manifold.
  std::vector<int> edge_triangles;
};

/// Mean length of the edges; 0 without edges.
double mean_edge(const Points& points, const AdjacencyList& neighbours);

/// 1 at the ends of edges that don't have two triangles, 0 elsewhere.
std::vector<char> border_vertices(const Connectivity& connectivity);

}
