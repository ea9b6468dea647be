#pragma once
// Normals at the vertices of a mesh.

#include "solver/mesh/TriangleMesh.h"

namespace vesicle
{

/// The triangles' normals weighted by area, one unit vector a row, on the side from which the
/// triangles are seen counter-clockwise; zero where no triangle with an area is.
Points vertex_normals(const Points& points, const Triangles& triangles);
/// The sums of which those are the directions: the triangles' normals, each as long as its
/// triangle's area is large.
Points vertex_area_vectors(const Points& points, const Triangles& triangles);

}
