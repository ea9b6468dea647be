#include "vtkVesicleCurvatureFilter.h"

#include "MeshConversion.h"

#include "solver/Errors.h"
#include "solver/surface/Cotan.h"
#include "solver/surface/FittedCurvature.h"
#include "solver/membrane/HelfrichBending.h"
#include "solver/mesh/BodyOrientation.h"
#include "solver/mesh/Connectivity.h"
#include "solver/mesh/MeshInspection.h"
#include "solver/surface/LoopCurvature.h"

#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace
{

using vesicle::TriangleMesh;
using Mask = std::vector<bool>;

/// Where the curvature is defined: triangles all around the vertex.
Mask inner_vertices(const vesicle::Connectivity& connectivity)
{
  const std::vector<char> border = vesicle::border_vertices(connectivity);
  Mask inner(border.size());
  for (std::size_t i = 0; i < inner.size(); ++i)
  {
    inner[i] = !border[i] && connectivity.vertex_triangles.size(static_cast<int>(i)) > 0;
  }
  return inner;
}

/// Where the vertex and all its neighbours are valid.
Mask with_valid_neighbours(const Mask& valid, const vesicle::AdjacencyList& neighbours)
{
  Mask result = valid;
  for (std::size_t i = 0; i < valid.size(); ++i)
  {
    const int vertex = static_cast<int>(i);
    for (const int* j = neighbours.begin(vertex); j != neighbours.end(vertex); ++j)
    {
      result[i] = result[i] && valid[*j];
    }
  }
  return result;
}

/// Zero and invalid where a value is not a number (degenerate triangles).
void drop_invalid(Eigen::VectorXd& values, Mask& valid)
{
  for (Eigen::Index i = 0; i < values.size(); ++i)
  {
    valid[i] = valid[i] && std::isfinite(values[i]);
    values[i] = valid[i] ? values[i] : 0;
  }
}

/// Seen from the middle of its box: what is computed of coordinates loses no digits far from the
/// origin.
void centre(TriangleMesh& mesh)
{
  const Eigen::RowVector3d middle =
    (mesh.points.colwise().minCoeff() + mesh.points.colwise().maxCoeff()) / 2;
  mesh.points.rowwise() -= middle;
}

/// What is to be said of bodies that face inward; empty: nothing. A mesh of one body that does
/// counts as facing outward without a word.
std::string facing_text(const vesicle::BodyOrientation& orientation)
{
  std::string text;
  const auto add = [&text](const std::string& sentence)
  { text += (text.empty() ? "" : "; ") + sentence; };
  for (std::size_t i = 0; i < orientation.bodies.size(); ++i)
  {
    if (orientation.turned[i] && orientation.bodies.size() > 1)
    {
      add(to_text(orientation.bodies[i]) + " is inside out and counts as facing outward" +
        (orientation.inner_side[i] ? ", as the inner side of a shell" : ""));
    }
    else if (orientation.inner_side[i])
    {
      add(to_text(orientation.bodies[i]) +
        " lies in another and faces inward, as the inner side of a shell: its mean curvature is "
        "that seen from within");
    }
  }
  return text;
}

vtkSmartPointer<vtkUnsignedCharArray> to_array(const char* name, const Mask& mask)
{
  auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
  array->SetName(name);
  for (const bool valid : mask)
  {
    array->InsertNextValue(valid);
  }
  return array;
}

constexpr const char* scheme_names[] = { "fit", "cotan", "loop" };

/// By the scheme's name; the fit adds its own arrays.
vesicle::Curvature curvature_of(const TriangleMesh& mesh, const vesicle::Connectivity& connectivity,
  int scheme, const vesicle::Progress& progress, vtkPointData* arrays)
{
  switch (scheme)
  {
    case vtkVesicleCurvatureFilter::Cotan:
      return vesicle::cotan_curvature(vesicle::CotanGeometry(mesh.points, mesh.triangles),
        mesh.points, vesicle::NormalScheme::area_weighted);
    case vtkVesicleCurvatureFilter::Loop:
      return vesicle::loop_curvature(mesh, progress);
    default:
    {
      auto fit = vesicle::fitted_curvature(mesh, connectivity, progress);
      arrays->AddArray(vesicle::to_array("Fit_Residual", fit.residual));
      arrays->AddArray(vesicle::to_array("Fit_Degree", Eigen::VectorXd(fit.degree.cast<double>())));
      return std::move(fit.curvature);
    }
  }
}

/// The mesh may have neither points nor triangles.
void add_curvatures(const TriangleMesh& mesh, int scheme, double rigidity,
  const vesicle::Progress& progress, vtkPointData* arrays)
{
  const vesicle::Connectivity connectivity(mesh.triangles, static_cast<int>(mesh.points.rows()));
  auto curvature = curvature_of(mesh, connectivity, scheme, progress, arrays);
  Mask valid = inner_vertices(connectivity);
  drop_invalid(curvature.mean, valid);
  drop_invalid(curvature.gauss, valid);
  drop_invalid(curvature.mean, valid);
  Mask force_valid = with_valid_neighbours(valid, connectivity.vertex_neighbours);
  drop_invalid(curvature.laplacian_mean, force_valid);
  Eigen::VectorXd density = rigidity * vesicle::bending_density(curvature);
  drop_invalid(density, force_valid);
  curvature.normal = curvature.normal.unaryExpr([](double n) { return std::isfinite(n) ? n : 0; });
  const vesicle::Points force = curvature.normal.array().colwise() * density.array();

  arrays->AddArray(vesicle::to_array("Gauss_Curvature", curvature.gauss));
  arrays->AddArray(vesicle::to_array("Laplacian_Mean_Curvature", curvature.laplacian_mean));
  arrays->AddArray(vesicle::to_array("Bending_Force", force));
  arrays->AddArray(to_array("Curvature_Valid", valid));
  arrays->AddArray(to_array("Bending_Force_Valid", force_valid));
  arrays->AddArray(vesicle::to_array("Mean_Curvature", curvature.mean));
  arrays->SetNormals(vesicle::to_array("Normals", curvature.normal));
}

// In the order of VTK_CURVATURE_GAUSS, …
constexpr const char* type_names[] = { "Gauss_Curvature", "Mean_Curvature", "Maximum_Curvature",
  "Minimum_Curvature" };

void invert(vtkDataArray* array)
{
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    array->SetComponent(i, 0, -array->GetComponent(i, 0));
  }
}

/// H + sign √(H² − K); the fits leave H² − K below 0 at most by their error.
void add_principal_curvature(const char* name, double sign, vtkPointData* arrays)
{
  vtkDataArray *mean = arrays->GetArray("Mean_Curvature"),
               *gauss = arrays->GetArray("Gauss_Curvature");
  vtkNew<vtkDoubleArray> principal;
  principal->SetName(name);
  for (vtkIdType i = 0; i < mean->GetNumberOfTuples(); ++i)
  {
    const double H = mean->GetComponent(i, 0), K = gauss->GetComponent(i, 0);
    principal->InsertNextValue(H + sign * std::sqrt(std::max(0.0, H * H - K)));
  }
  arrays->AddArray(principal);
}

/// Thrown where AbortExecute was seen.
struct Aborted
{
};

}

vtkStandardNewMacro(vtkVesicleCurvatureFilter);

void vtkVesicleCurvatureFilter::SetSchemeByName(const char* name)
{
  for (int scheme = Fit; scheme <= Loop; ++scheme)
  {
    if (name && std::string(name) == scheme_names[scheme])
    {
      this->SetScheme(scheme);
      return;
    }
  }
  vtkErrorMacro(<< "unknown scheme '" << (name ? name : "") << "'; there are: fit, cotan, loop");
}

const char* vtkVesicleCurvatureFilter::GetSchemeName()
{
  return scheme_names[this->Scheme];
}

int vtkVesicleCurvatureFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const vesicle::Progress progress = [this](double share)
  {
    this->UpdateProgress(share);
    if (this->GetAbortExecute())
    {
      throw Aborted();
    }
  };
  constexpr double read = 0.05, checked = 0.15, computed = 0.95;
  try
  {
    output->ShallowCopy(vesicle::triangulated(input));
    progress(read);
    if (output->GetNumberOfPolys() == 0)
    {
      vtkWarningMacro(<< "the input has no triangles: no curvature is computed");
      return 1;
    }
    TriangleMesh mesh = vesicle::to_mesh(output);
    if (!vesicle::MeshInspection(mesh).oriented())
    {
      vtkWarningMacro(
        << "neighbouring triangles disagree on the orientation: signs of curvatures and "
           "normals mean little; use vtkPolyDataNormals with ConsistencyOn first");
    }
    if (this->OrientOutward)
    {
      vesicle::BodyOrientation orientation(mesh);
      mesh.triangles = std::move(orientation.triangles);
      if (const std::string text = facing_text(orientation); !text.empty())
      {
        vtkWarningMacro(<< text);
      }
    }
    progress(checked);
    centre(mesh);
    vesicle::use_double_points(output);
    vtkPointData* arrays = output->GetPointData();
    add_curvatures(mesh, this->Scheme, this->BendingRigidity,
      vesicle::part_of(progress, checked, computed), arrays);
    progress(computed);
    if (this->InvertMeanCurvature)
    {
      invert(arrays->GetArray("Mean_Curvature"));
    }
    if (this->CurvatureType >= VTK_CURVATURE_MAXIMUM)
    {
      add_principal_curvature(type_names[this->CurvatureType],
        this->CurvatureType == VTK_CURVATURE_MAXIMUM ? 1 : -1, arrays);
    }
    arrays->SetActiveScalars(type_names[this->CurvatureType]);
    return 1;
  }
  catch (const Aborted&)
  {
    output->Initialize();
    return 1;
  }
  catch (const std::exception& error)
  {
    output->Initialize();
    vtkErrorMacro(<< error.what());
    return 0;
  }
}

void vtkVesicleCurvatureFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CurvatureType: " << type_names[this->CurvatureType] << '\n';
  os << indent << "InvertMeanCurvature: " << (this->InvertMeanCurvature ? "on" : "off") << '\n';
  os << indent << "Scheme: " << this->GetSchemeName() << '\n';
  os << indent << "BendingRigidity: " << this->BendingRigidity << '\n';
  os << indent << "OrientOutward: " << (this->OrientOutward ? "on" : "off") << '\n';
}
