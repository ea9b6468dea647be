#pragma once
// Area, volume and centroid of a mesh of flat triangles.

#include "solver/mesh/TriangleMesh.h"

namespace vesicle
{

/// Area of the flat triangles.
double flat_area(const TriangleMesh& mesh);
/// Volume enclosed by the flat triangles of a closed mesh, positive if they face outward.
double flat_volume(const TriangleMesh& mesh);
/// Centroid of the volume enclosed by the flat triangles. Throws InputError if it is none.
Vector3 volume_centroid(const TriangleMesh& mesh);

/// v = 6 √π V / A^{3/2}, paper (43); 1 on a sphere. Throws InputError unless the area is positive.
double reduced_volume(double area, double volume);
/// The same of the flat triangles.
double flat_reduced_volume(const TriangleMesh& mesh);

}
