#pragma once
// Meshes with twelve vertices of valence five and all others of valence six on star-shaped bodies.

#include "solver/mesh/remesh/SurfaceSmoother.h"

#include <optional>

namespace vesicle
{

/// The uniform_mesh() of an ellipsoid with the body's principal axes, projected onto its surface
/// along the rays from the origin and smoothed there: `triangles` triangles to 1%. Nothing where
/// rays cross the surface more than once, or the mesh doesn't resolve it. The origin is the body's
/// centroid.
std::optional<EditableMesh> projected_mesh(const SurfaceSmoother& smoother, int triangles);

}
