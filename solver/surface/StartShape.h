#pragma once
// Start shapes by the measures of the surface that their mesh stands for.

#include "solver/mesh/TriangleMesh.h"
#include "solver/mesh/shapes/ShapeRequest.h"
#include "solver/mesh/shapes/SphereMesh.h"
#include "solver/surface/SurfaceBasis.h"

#include <string>

namespace vesicle
{

/// The shape whose surface has the reduced volume asked for, to 1e-12, and the volume of the unit
/// sphere (r0 = 1). Meshes are even, but those of surfaces of revolution whose bending energy Loop's
/// surface would miss by more than 1e-3: they have small triangles where the shape is bent
/// (GradedMesh.h). Where Loop's surface can't be as round as asked for, it is as round as it can be:
/// 80 triangles have a reduced volume of at most 1 − 4e-6. Throws InputError.
TriangleMesh make_start_shape(const ShapeRequest& request, SurfaceBasis basis);

/// The graded mesh whose Loop surface holds the reduced volume and the bending energy of any surface
/// best.
SphereMesh loop_mesh(const SphericalParametrisation& surface, int triangles, Symmetry symmetry);

/// What the mesh doesn't hold of the shape that was asked for: a reduced volume, or its bending
/// energy to 1%, with the number of triangles that would. Empty if nothing. Flat triangles, whose
/// energy is off by more, aren't asked.
std::string start_shape_warning(
  const ShapeRequest& request, SurfaceBasis basis, const TriangleMesh& mesh);

/// The turn that takes the z axis to `axis`, of any length but 0.
Eigen::Matrix3d turn_z_to(const Vector3& axis);

/// A shape of r0 = 1 scaled to a radius, turned about the origin and moved to a centre.
void place(TriangleMesh& shape, double radius, const Eigen::Matrix3d& turn, const Vector3& center);

}
