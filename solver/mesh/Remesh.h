#pragma once
// Makes the mesh of a smooth surface uniform and well shaped: nodes move along the exact surface
// and edges flip; the numbers of points and triangles stay.

#include "solver/mesh/ShapeFamily.h"
#include "solver/mesh/SphereMesh.h"

namespace vesicle
{

/// The flat triangles through the surface's points above mesh.directions.
TriangleMesh surface_mesh(const SphereImage& surface, const SphereMesh& mesh);

/// `passes` rounds of tangential smoothing and flips of the mesh on `surface`. Vertices keep
/// between 4 and 8 neighbours; the directions always triangulate the sphere, so that the surface is
/// covered once; half turns are kept.
void improve(SphereMesh& mesh, const SphereImage& surface, int passes);

/// A mesh of 20 n² triangles of nearly equal size on `surface`. Long-wave unevenness is smoothed on
/// coarse meshes, which are then cut in four.
SphereMesh uniform_mesh(const SphereImage& surface, int n, bool symmetric);

}
