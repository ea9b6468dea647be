#pragma once
// A triangle mesh: points and the triangles between them, and what follows from the triangles
// alone.

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <string>
#include <vector>

namespace vesicle
{

using Vector3 = Eigen::Vector3d;
/// #points by 3, one point a row.
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
/// #triangles by 3 indices into Points, counter-clockwise seen from outside.
using Triangles = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;

struct TriangleMesh
{
  Points points;
  Triangles triangles;
};

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

/// What a mesh is, for reports and for the checks below.
struct Topology
{
  bool closed = false;   ///< every edge has two triangles or more
  bool manifold = false; ///< no edge has more than two; the triangles at a vertex form one fan
  bool oriented = false; ///< neighbouring triangles agree on the orientation
  int components = 0;    ///< edge-connected, of vertices that a triangle uses
  int genus = 0;         ///< of a closed, manifold mesh, summed over the components; otherwise 0
};
Topology topology(const TriangleMesh& mesh);

/// Makes `mesh` fit for dynamics: closed, manifold, consistently oriented, one component, genus 0,
/// no degenerate triangle, no duplicate or unused point, finite coordinates. A consistently inward
/// mesh is flipped, and inconsistent orientations of an orientable mesh are mended; the returned
/// text then says so (empty: nothing was changed). Throws InputError naming the place (vertex,
/// triangle or edge with its coordinates) and a remedy, prefixed with `name`.
std::string prepare_for_dynamics(TriangleMesh& mesh, const std::string& name);

/// The structural part that any use needs: indices in range, finite coordinates. Throws InputError.
void check_indices(const TriangleMesh& mesh, const std::string& name);

/// Area of the flat triangles.
double flat_area(const TriangleMesh& mesh);
/// Volume enclosed by the flat triangles of a closed mesh, positive if they face outward.
double flat_volume(const TriangleMesh& mesh);
/// Centroid of the enclosed volume.
Vector3 volume_centroid(const TriangleMesh& mesh);
/// v = 6 √π V / A^{3/2}, paper (43); 1 on a sphere.
double reduced_volume(double area, double volume);

}
