#pragma once
// A mesh laid anew on the surface that another one has become too coarse, too fine or too skewed for.

#include "solver/surface/LimitSurface.h"
#include "solver/surface/Surface.h"

namespace vesicle
{

struct AdaptedMesh
{
  TriangleMesh mesh;                ///< its points are on the surface
  std::vector<SurfacePlace> places; ///< where
};

/// A mesh of about `triangles` triangles on a smooth surface of genus 0, whose edges follow the sizing
/// law (SizingLaw.h): of twelve vertices of five neighbours and all others of six. The triangulations
/// of the sphere that have that many (SphereTriangulations.h) are laid around each of three axes such
/// that each row has its share of the triangles, then vertices spread along the surface. Where none of
/// them does well the surface's own mesh is brought to the law (GradedRemeshing.h). The best is taken, by
/// loop_error() and the smallest angle. The same surface has the same mesh. Throws
/// NumericalError where no mesh fits.
AdaptedMesh adapted_mesh(const Surface& surface, int triangles);

}
