#pragma once
// What is known of a solved vesicle, as numbers in a data set: point arrays, and field data from
// which the flow around it can be computed again.

#include "VesicleFiltersModule.h"

#include "solver/dynamics/Diagnostics.h"
#include "solver/mesh/TriangleMesh.h"
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

/// Field data of one tuple, or of a tuple for each vesicle.
VESICLEFILTERS_EXPORT void add_number(vtkFieldData* to, const char* name, double value);
VESICLEFILTERS_EXPORT void add_numbers(
  vtkFieldData* to, const char* name, const std::vector<double>& values);

/// The point array Vesicle_Id: which vesicle, from 0, each point is of.
VESICLEFILTERS_EXPORT void add_vesicle_ids(const std::vector<int>& ids, vtkPolyData* surface);
/// The vesicles of a surface, by Vesicle_Id, or without it, of a closed one, by what is connected: the
/// points of each, ascending; of a single one all. Throws InputError where a triangle has points of different vesicles.
VESICLEFILTERS_EXPORT std::vector<std::vector<int>> vesicle_points(vtkPolyData* surface);
/// The part of a mesh that has these points, which it keeps in this order.
VESICLEFILTERS_EXPORT TriangleMesh part_with(
  const TriangleMesh& mesh, const std::vector<int>& points);

/// What surface the points stand for, as field data: Surface_Basis, 0 flat triangles, 1 Loop's
/// surface; and the Reduced_Volume of that surface.
VESICLEFILTERS_EXPORT void add_surface(SurfaceBasis basis, double reduced_volume, vtkFieldData* to);

/// By the field data Surface_Basis; flat triangles where there is none.
VESICLEFILTERS_EXPORT SurfaceBasis surface_basis(vtkFieldData* from);

/// The scene's medium as field data: Viscosity; Viscosity_Ratio, of each vesicle; Surface_Basis, 0 linear, 1 Loop; Flow_Kind, 0 at
/// rest or the number of a kind (flow/FlowKinds.h), and the numbers of the flow
/// (flow/FlowNumbers.h): Flow_Rate, Flow_Velocity (three components; Poiseuille's on the axis),
/// Flow_Radius, Flow_Center, Flow_Axis, as far as the kind has them; of a flow with a history those at
/// the time; with a wall Wall_Point and Wall_Normal, three components each.
VESICLEFILTERS_EXPORT void add_medium(const Scene& scene, double time, vtkFieldData* to);

/// What add_medium wrote; nothing else of the scene is set, which has as many vesicles as there are
/// viscosity ratios. Throws InputError naming the array that is missing or makes no sense.
VESICLEFILTERS_EXPORT Scene read_medium(vtkFieldData* from);

}
