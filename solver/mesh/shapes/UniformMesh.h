#pragma once
// Makes the mesh of a smooth surface uniform and well shaped: nodes move along the exact surface,
// the triangulation stays.

#include "solver/mesh/shapes/ShapeFamily.h"
#include "solver/mesh/shapes/SphereMesh.h"

namespace vesicle
{

/// The flat triangles through the surface's points above mesh.directions.
TriangleMesh surface_mesh(const SphereImage& surface, const SphereMesh& mesh);

/// `passes` rounds of tangential smoothing of the mesh on `surface`. The directions always
/// triangulate the sphere, so that the surface is covered once; half turns are kept.
void improve(SphereMesh& mesh, const SphereImage& surface, int passes);

/// A mesh of triangles of nearly equal size on `surface`: the capped tube or geodesic sphere that
/// suits it best, with twelve vertices of five neighbours and all others of six. It has the number
/// of triangles asked for if that is a multiple of 10 or 12 up to 2,000, of 40 or 48 up to 8,000
/// and so on: finer meshes are cut from coarser ones, on which long-wave unevenness is smoothed.
/// Otherwise the nearest such number; with Symmetry::half_turns a multiple of 12 or 20 n².
SphereMesh uniform_mesh(const SphereImage& surface, int triangles, Symmetry symmetry);

}
