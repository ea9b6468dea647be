#pragma once
// Normals at the vertices of a mesh as weighted means of the triangles' normals.

#include "solver/mesh/TriangleMesh.h"

namespace vesicle
{

/// What a triangle's normal counts at a corner with the edges e1, e2 and the angle α.
enum class NormalWeights
{
  area,          ///< the triangle's area
  inverse_edges, ///< sin α/(|e1| |e2|), exact on a sphere (N. Max, J. Graphics Tools 4 (1999), no.
                 ///< 2, 1–6)
};

/// Unit normals on the side from which the triangles are seen counter-clockwise, one a row; zero
/// where no triangle with an area is.
Points vertex_normals(const Points& points, const Triangles& triangles, NormalWeights weights);

}
