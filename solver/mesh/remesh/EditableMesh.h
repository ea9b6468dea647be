#pragma once
// A mesh under construction on a smooth surface.

#include "solver/mesh/EdgeUses.h"
#include "solver/mesh/MeshQuality.h"

namespace vesicle
{

/// A closed, oriented manifold on a surface of size about 1, with the surface's outward normals at
/// its points.
struct EditableMesh
{
  Points points;
  Points normals;
  Triangles triangles;
  /// Vertices that anything else refers to: kept up to date as vertices are removed and renumbered.
  std::vector<int> references;
  /// The edge length that is wanted at each vertex; empty: 1 everywhere.
  Eigen::VectorXd sizes;

  Vector3 point(int i) const { return points.row(i); }
  Vector3 normal(int i) const { return normals.row(i); }
  /// In the length that is wanted there.
  double length(int a, int b) const;
  /// Does triangle (a, b, c) face outward, as its corners' normals do?
  bool faces_outward(int a, int b, int c) const;
  /// How far the edge between a and b leaves the surface: the larger sine of its angles with the
  /// tangent planes at its ends; half its length over the radius of curvature where that is small.
  double steepness(int a, int b) const;

  MeshQuality quality() const;

  /// The number of each vertex' neighbours.
  std::vector<int> valences() const;

  /// The edges (numbered as in `edges`) longer than `low` and shorter than `high`, the shortest
  /// first. Lengths that agree but for rounding count as equal and the numbering decides, so that a
  /// turned mesh is treated alike.
  std::vector<int> edges_between(double low, double high, const EdgeUses& edges) const;
};

}
