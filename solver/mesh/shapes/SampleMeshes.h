#pragma once
// Meshes and surfaces on which accuracy is measured: regular and irregular, spherical and not.

#include "solver/mesh/shapes/SphericalParametrisation.h"

namespace vesicle
{

/// A unit sphere with about that many triangles, smooth enough for Loop's surface.
TriangleMesh smooth_sphere(int triangles);

/// A geodesic sphere with its points shifted along the sphere by up to `fraction` of the mean edge,
/// by a fixed pseudo-random sequence: triangles of all sizes and angles.
TriangleMesh jittered_sphere(int n, double fraction);

/// Edges flipped until the triangulation of points on a sphere is their convex hull (Delaunay).
TriangleMesh delaunay_sphere(const TriangleMesh& sphere);

/// Spherical parametrisations: (2 n_x, n_y, n_z), the ellipsoid of data/reference.
Vector3 ellipsoid_2_1_1(const Vector3& direction);
/// r = 1 + 0.2 Y20.
Vector3 perturbed_sphere(const Vector3& direction);
/// r = 1 + 0.61 n_x + 0.4 n_x² n_y, the smooth variant of the paper's 4.1.
Vector3 paper_surface(const Vector3& direction);
/// The paper's 4.1 as printed, r = 1 + 0.61 n_x + 0.4 n_x² n_y/(n_x² + n_y²): conical at the poles
/// n_x = n_y = 0, with the same section z = 0.
Vector3 printed_paper_surface(const Vector3& direction);

}
