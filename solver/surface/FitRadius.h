#pragma once
// How good fitted curvatures of a mesh are, and which radius makes them better.

#include "solver/surface/FittedCurvature.h"

#include <optional>

namespace vesicle
{

/// The typical standard error of H as a share of the typical curvature: medians over the vertices,
/// but for those on borders and without a fit, of mean_error and of √((κ1² + κ2²)/2), which counts
/// as at least one over the diagonal of the mesh's box. About 0.01 or less of a smooth mesh, 0.1 of
/// an isosurface of smooth data, 0.5 where all is noise.
double typical_error(const TriangleMesh& mesh, const FittedCurvature& fit);

/// The smallest radius (FitOptions) with a typical error of `wanted`, judged by a few hundred
/// vertices. None: with fewer than twelve points it isn't reached, nor with more up to the radius
/// of curvature, as the mesh is too coarse or too noisy for its shape.
std::optional<double> radius_for_error(
  const TriangleMesh& mesh, const Connectivity& connectivity, double wanted = 0.03);

}
