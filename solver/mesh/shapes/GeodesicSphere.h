#pragma once
// The icosahedron's faces cut into smaller ones and projected onto the sphere.

#include "solver/mesh/TriangleMesh.h"

namespace vesicle
{

/// A sphere of radius 1 with triangles of nearly equal size: the icosahedron's faces cut in n²
/// (class I, n ≥ 1) and projected: 20 n² triangles, 10 n² + 2 vertices. Throws InputError for other
/// n.
TriangleMesh geodesic_sphere(int n);
/// The n for which 20 n² is nearest to `triangles`.
int geodesic_frequency(int triangles);

}
