#include "vtkVesicleCurvatureFilter.h"

#include "CurvatureArrays.h"
#include "MeshConversion.h"
#include "SurfacePorts.h"

#include "solver/ProgressCallback.h"
#include "solver/mesh/BodyOrientation.h"
#include "solver/mesh/MeshInspection.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace
{

using vesicle::TriangleMesh;
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

constexpr const char* scheme_names[] = { "fit", "cotan", "loop" };

/// Of triangles around a vertex that its curvature is fitted to; the Laplacian is fitted to curvatures
/// of as many.
constexpr double least_rings = 2;
/// More are asked for as "all there are".
constexpr double most_rings = 1000;

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

int vtkVesicleCurvatureFilter::FillInputPortInformation(int, vtkInformation* info)
{
  vesicle::take_surfaces(info);
  return 1;
}

int vtkVesicleCurvatureFilter::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->Superclass::RequestUpdateExtent(request, inputs, outputs);
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* input = inputs[0]->GetInformationObject(0);
  if (input->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) > 1)
  {
    const int rings =
      static_cast<int>(std::ceil(std::clamp(this->FitRings, least_rings, most_rings)));
    input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(),
      2 * rings + input->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS()));
  }
  return 1;
}

int vtkVesicleCurvatureFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataObject* input = vtkDataObject::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const vesicle::ProgressCallback progress = [this](double share)
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
    output->ShallowCopy(vesicle::triangulated(input, "input"));
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
    const vesicle::CurvatureSettings settings{ this->Scheme, this->CurvatureType,
      this->InvertMeanCurvature != 0, this->BendingRigidity, this->FitRadius, this->FitRings,
      this->BendingForce, this->PrincipalCurvatures, this->ShapeDescriptors, this->UndefinedIsNaN };
    const std::string remark = vesicle::add_curvature_arrays(
      mesh, settings, vesicle::part_of(progress, checked, computed), arrays);
    progress(computed);
    if (!remark.empty())
    {
      vtkWarningMacro(<< remark);
    }
    arrays->SetActiveScalars(vesicle::curvature_array_name(this->CurvatureType));
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
  os << indent << "CurvatureType: " << vesicle::curvature_array_name(this->CurvatureType) << '\n';
  os << indent << "InvertMeanCurvature: " << (this->InvertMeanCurvature ? "on" : "off") << '\n';
  os << indent << "Scheme: " << this->GetSchemeName() << '\n';
  os << indent << "BendingRigidity: " << this->BendingRigidity << '\n';
  os << indent << "FitRadius: " << this->FitRadius << '\n';
  os << indent << "FitRings: " << this->FitRings << '\n';
  os << indent << "BendingForce: " << (this->BendingForce ? "on" : "off") << '\n';
  os << indent << "PrincipalCurvatures: " << (this->PrincipalCurvatures ? "on" : "off") << '\n';
  os << indent << "ShapeDescriptors: " << (this->ShapeDescriptors ? "on" : "off") << '\n';
  os << indent << "UndefinedIsNaN: " << (this->UndefinedIsNaN ? "on" : "off") << '\n';
  os << indent << "OrientOutward: " << (this->OrientOutward ? "on" : "off") << '\n';
}
