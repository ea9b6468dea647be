#pragma once
// The point arrays of vtkVesicleCurvatureFilter, whose header says what they hold.

#include "solver/ProgressCallback.h"
#include "solver/mesh/TriangleMesh.h"

#include <string>

class vtkPointData;

namespace vesicle
{

/// The filter's properties.
struct CurvatureSettings
{
  int scheme, type;
  bool inverted;
  double bending_rigidity;
  double fit_radius, fit_rings;
  bool bending_force, principal_curvatures, shape_descriptors;
  bool undefined_is_nan;
};

/// Adds them for a mesh that may have neither points nor triangles, and whose triangles'
/// orientation counts. Returns what is to be said of their quality; empty: nothing. Throws
/// InputError where the mesh doesn't take the scheme or the radius.
std::string add_curvature_arrays(const TriangleMesh& mesh, const CurvatureSettings& settings,
  const ProgressCallback& progress, vtkPointData* arrays);

/// The array of VTK_CURVATURE_GAUSS, …
const char* curvature_array_name(int type);

}
