#pragma once
// A closed triangulation whose edges can be flipped, in half-edge form.

#include "solver/mesh/TriangleMesh.h"

#include <vector>

namespace vesicle
{

/// Half-edge 3t + k runs from corner k of triangle t to the next one.
class HalfEdgeMesh
{
public:
  /// The triangles of a closed, oriented manifold.
  HalfEdgeMesh(const Triangles& triangles, int points);

  int half_edges() const { return static_cast<int>(twins_.size()); }
  int from(int h) const { return corners_(h / 3, h % 3); }
  int to(int h) const { return from(next(h)); }
  int apex(int h) const { return from(previous(h)); }
  int twin(int h) const { return twins_[h]; }
  int valence(int vertex) const { return valences_[vertex]; }
  const Triangles& triangles() const { return corners_; }

  /// The half-edge from a to b, −1 if they aren't neighbours.
  int find(int a, int b) const;
  /// Replaces the edge of half-edge h by the one between the apices of its two triangles.
  void flip(int h);

private:
  static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static int previous(int h) { return h % 3 == 0 ? h + 2 : h - 1; }
  void pair(int h, int g);

  Triangles corners_;
  std::vector<int> twins_;
  std::vector<int> outgoing_; ///< one half-edge from each vertex
  std::vector<int> valences_;
};

}
