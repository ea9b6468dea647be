#pragma once
// Start shapes: triangulations of a sphere, ellipsoids, the discocyte and perturbed spheres, of
// good quality, with the reduced volume that was asked for on the discrete mesh.

#include "solver/mesh/TriangleMesh.h"
#include "solver/mesh/shapes/ShapeRequest.h"

namespace vesicle
{

/// The mesh, with its discrete volume equal to that of the unit sphere (r0 = 1) and its volume
/// centroid at the origin. Throws InputError for what can't be (v outside the family's range, too
/// few triangles, negative axes, a perturbed radius that isn't positive …).
TriangleMesh make_shape(const ShapeRequest& request);

}
