#pragma once
// Area, volume and bending energy of the surface that a mesh stands for, as the dynamics have them.

#include "solver/surface/SurfaceBasis.h"
#include "solver/mesh/TriangleMesh.h"

namespace vesicle
{

/// In the units of the mesh; the volume is positive if the triangles face outward.
struct SurfaceMeasures
{
  double area, volume;
  double bending_energy; ///< 2 ∮ H² dS (EB = 1): 8π on a sphere
};

/// Of a closed, oriented mesh; Loop's surface takes a manifold one with three or more neighbours at
/// every point. Throws InputError.
SurfaceMeasures surface_measures(SurfaceBasis basis, const TriangleMesh& mesh);

/// r0 = (3V/4π)^{1/3}, the radius of the sphere of the same volume.
double equivalent_radius(double volume);

}
