#pragma once
// The connected parts of a mesh.

#include "solver/mesh/TriangleMesh.h"

#include <vector>

namespace vesicle
{

struct Component
{
  std::vector<int> triangles; ///< ascending
  double area = 0;
};

/// Connected by points, in the order of their first triangles.
std::vector<Component> components_of(const TriangleMesh& mesh);

/// A mesh of some triangles and the points that they use.
TriangleMesh part_of(const TriangleMesh& mesh, const std::vector<int>& triangles);
/// The points that some triangles use, ascending: those of part_of() in their order.
std::vector<int> points_of(const TriangleMesh& mesh, const std::vector<int>& triangles);

}
