#pragma once
// Start shapes by the measures of the surface that their mesh stands for.

#include "solver/mesh/TriangleMesh.h"
#include "solver/mesh/shapes/ShapeRequest.h"
#include "solver/surface/SurfaceBasis.h"

namespace vesicle
{

/// The shape whose surface has the reduced volume asked for, to 1e-6, and the volume of the unit
/// sphere (r0 = 1); make_shape() makes the same of flat triangles, whatever the basis. Throws
/// InputError.
TriangleMesh make_start_shape(const ShapeRequest& request, SurfaceBasis basis);

/// The turn that takes the z axis to `axis`, of any length but 0.
Eigen::Matrix3d turn_z_to(const Vector3& axis);

/// A shape of r0 = 1 scaled to a radius, turned about the origin and moved to a centre.
void place(TriangleMesh& shape, double radius, const Eigen::Matrix3d& turn, const Vector3& center);

}
