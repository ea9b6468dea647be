#pragma once
// Several meshes as one.

#include "solver/mesh/TriangleMesh.h"

#include <vector>

namespace vesicle
{

/// Points and triangles of one mesh after those of the other, in the order of the meshes.
TriangleMesh joined(const std::vector<TriangleMesh>& meshes);

/// Of the triangle (from 0) of joined meshes: which mesh it is of.
std::size_t mesh_of_triangle(const std::vector<TriangleMesh>& meshes, Eigen::Index triangle);

}
