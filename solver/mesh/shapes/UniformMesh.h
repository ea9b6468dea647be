#pragma once
// Uniform meshes of smooth surfaces.

#include "solver/mesh/shapes/SphereMesh.h"

namespace vesicle
{

/// A mesh of triangles of nearly equal size on `surface`: the capped tube or geodesic sphere that
/// suits it best, with twelve vertices of five neighbours and all others of six. It has the number
/// of triangles asked for if that is a multiple of 10 or 12 up to 2,000, of 40 or 48 up to 8,000
/// and so on: finer meshes are cut from coarser ones, on which long-wave unevenness is smoothed.
/// Otherwise the nearest such number; with Symmetry::half_turns a multiple of 12 or 20 n².
SphereMesh uniform_mesh(const SphericalParametrisation& surface, int triangles, Symmetry symmetry);

}
