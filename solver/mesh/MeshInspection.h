#pragma once
// What is wrong with a triangle mesh, and where: the questions that topology() and
// prepare_for_dynamics() ask.

#include "solver/mesh/EdgeUses.h"

#include <string>
#include <vector>

namespace vesicle
{

class MeshInspection
{
public:
  explicit MeshInspection(const TriangleMesh& mesh);

  const EdgeUses& edges() const { return uses_; }
  /// The first edge with one triangle only, or with more than two; −1 if there is none.
  int first_border_edge() const;
  int first_nonmanifold_edge() const;
  /// Connected pieces of the open border.
  int holes() const;
  /// The first vertex at which the triangles form several fans, −1 if there is none.
  int first_nonmanifold_vertex() const;
  bool used(int vertex) const { return is_used_[vertex]; }
  int used_vertices() const;
  /// A vertex of each edge-connected component, by ascending vertex.
  std::vector<int> component_vertices() const;
  /// What keeps the mesh from being a manifold, and where, in words; empty if it is one.
  std::string nonmanifold_place(const Points& points) const;
  /// Do neighbouring triangles run through their common edges in opposite directions?
  bool oriented() const;
  struct Reorientation
  {
    std::vector<bool> flipped;   ///< the triangles to turn over
    int contradicting_edge = -1; ///< an edge where that fails: one-sided, as Klein's bottle
  };
  /// How to make all triangles agree with the first one of their component.
  Reorientation reorientation() const;

private:
  template<typename Condition>
  int first_edge(Condition holds) const;

  EdgeUses uses_;
  Triangles triangles_;
  std::vector<bool> is_used_;
};

/// "near (1, 0, 0)".
std::string near_text(const Vector3& x);

}
