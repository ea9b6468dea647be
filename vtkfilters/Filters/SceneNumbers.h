#pragma once
// What is known of a solved vesicle, as numbers in a data set: point arrays, and field data from
// which the flow around it can be computed again.

#include "VesicleFiltersModule.h"

#include "solver/dynamics/Diagnostics.h"
#include "solver/scene/Scene.h"

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

class vtkFieldData;
class vtkPolyData;

namespace vesicle
{

/// The point arrays of Simulation::fields that the scene's output.fields chooses; arrays of the
/// surface that have a name of the output contract give way. Mean_Curvature, Normals and Velocity
/// become the active scalars, normals and vectors.
VESICLEFILTERS_EXPORT void add_fields(
  const std::map<std::string, Eigen::MatrixXd>& fields, const Scene& scene, vtkPolyData* surface);

/// Field data of one tuple.
VESICLEFILTERS_EXPORT void add_number(vtkFieldData* to, const char* name, double value);

/// What surface the points stand for, as field data: Surface_Basis, 0 flat triangles, 1 Loop's
/// surface; and the Reduced_Volume of that surface.
VESICLEFILTERS_EXPORT void add_surface(SurfaceBasis basis, double reduced_volume, vtkFieldData* to);

/// By the field data Surface_Basis; flat triangles where there is none.
VESICLEFILTERS_EXPORT SurfaceBasis surface_basis(vtkFieldData* from);

/// The scene's medium as field data: Viscosity; Surface_Basis, 0 linear, 1 Loop; Flow_Kind, 0 at
/// rest or the number of a kind (flow/FlowKinds.h), and the numbers of the flow
/// (flow/FlowNumbers.h): Flow_Rate, Flow_Velocity (three components; Poiseuille's on the axis),
/// Flow_Radius, Flow_Center, Flow_Axis, as far as the kind has them; of a flow with a history those at
/// the time.
VESICLEFILTERS_EXPORT void add_medium(const Scene& scene, double time, vtkFieldData* to);

/// What add_medium wrote; nothing else of the scene is set. Throws InputError naming the array that
/// is missing or makes no sense.
VESICLEFILTERS_EXPORT Scene read_medium(vtkFieldData* from);

}
