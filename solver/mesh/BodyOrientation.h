#pragma once
// Which way each body of a mesh faces, and which way it should.

#include "solver/mesh/TriangleMesh.h"

#include <string>
#include <vector>

namespace vesicle
{

/// A closed, consistently oriented part of a mesh, its triangles connected by edges.
struct Body
{
  int first_triangle = 0;
  int triangles = 0;
  Vector3 centre = Vector3::Zero(); ///< the mean of its triangles' corners
  double volume = 0;                ///< negative if it faces inward
  int within = -1;                  ///< the outermost body that it lies in, −1: in none
};

/// "the body about (4, 0, 0) of 528 triangles".
std::string to_text(const Body& body);

/// A body that lies in no other should face outward. One within another may be a body of its own, or
/// the inner side of a shell, which faces inward on purpose: it is left as it stands to the
/// outermost body around it, and turned with that one.
struct BodyOrientation
{
  explicit BodyOrientation(const TriangleMesh& mesh);

  std::vector<Body> bodies;
  std::vector<bool> turned; ///< of each body: it is to be turned
  /// Of each body: it faces inward within another once all are turned.
  std::vector<bool> inner_side;
  /// The mesh with these bodies' triangles turned.
  Triangles triangles;

  bool any_turned() const;
};

}
