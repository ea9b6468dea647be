#include "vtkVesicleProbeFilter.h"

#include "ArrayLabels.h"
#include "MeshConversion.h"
#include "SceneNumbers.h"
#include "SurfacePorts.h"

#include "solver/Errors.h"
#include "solver/mesh/Preparation.h"
#include "solver/stokes/TwoFluidFlow.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace
{

using vesicle::Points;
using vesicle::TriangleMesh;
using Pipeline = vtkStreamingDemandDrivenPipeline;

// Between two of these many points progress is reported and AbortExecute looked at.
constexpr vtkIdType block_size = 4096;

/// A point array of the surface; nothing if there is none of that name.
std::optional<Eigen::MatrixXd> point_array(vtkPolyData* surface, const char* name, int components)
{
  vtkDataArray* array = surface->GetPointData()->GetArray(name);
  if (!array)
  {
    return {};
  }
  if (array->GetNumberOfComponents() != components)
  {
    throw vesicle::InputError(fmt::format("the source's array {} has {} components, not {}", name,
      array->GetNumberOfComponents(), components));
  }
  Eigen::MatrixXd values(array->GetNumberOfTuples(), components);
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      values(i, c) = array->GetComponent(i, c);
    }
  }
  if (!values.allFinite())
  {
    throw vesicle::InputError(
      fmt::format("the source's array {} has values that aren't finite", name));
  }
  return values;
}

TriangleMesh prepared(TriangleMesh mesh)
{
  const auto points = mesh.points.rows();
  vesicle::prepare_for_dynamics(mesh, "source");
  if (mesh.points.rows() != points)
  {
    throw vesicle::InputError(
      "the source has points that no triangle uses; drop them first (vtkCleanPolyData)");
  }
  return mesh;
}

Points forces_on(vtkPolyData* surface)
{
  const auto membrane = point_array(surface, "Membrane_Force", 3);
  if (!membrane)
  {
    throw vesicle::InputError("the source lacks the point array Membrane_Force, which frames of a "
                              "run (unless the scene's output.fields leaves it out), "
                              "vtkVesicleStepper and vtkVesicleForceFilter have");
  }
  Points forces = *membrane;
  for (const char* name : { "Gravity_Force", "Repulsion_Force" })
  {
    if (const auto others = point_array(surface, name, 3))
    {
      forces += *others;
    }
  }
  return forces;
}

/// Needed where the fluids differ.
Points velocities_of(vtkPolyData* surface, bool one_fluid)
{
  if (one_fluid)
  {
    return {};
  }
  const auto velocity = point_array(surface, "Velocity", 3);
  if (!velocity)
  {
    throw vesicle::InputError(
      "the source lacks the point array Velocity, which its Viscosity_Ratio "
      "other than 1 takes");
  }
  return *velocity;
}

/// What a source says of the flow around it. Outside u = u∞ + Σ (S f/μ − (1 − λ) K u) over the
/// vesicles, inside of one λ u is that.
class Flow
{
public:
  explicit Flow(vtkDataObject* source)
    : Surface(SurfaceOf(source)), Medium(vesicle::read_medium(this->Surface->GetFieldData()))
  {
    const std::vector<std::vector<int>> vesicles = vesicle::vesicle_points(this->Surface);
    const TriangleMesh mesh = vesicle::to_mesh(this->Surface);
    this->ReadRatios(vesicles.size());
    const Points forces = forces_on(this->Surface),
                 velocities = velocities_of(this->Surface,
                   std::all_of(this->Ratios.begin(), this->Ratios.end(),
                     [](double ratio) { return ratio == 1; }));
    for (std::size_t v = 0; v < vesicles.size(); ++v)
    {
      const auto& points = vesicles[v];
      this->Vesicles.emplace_back(prepared(vesicle::part_with(mesh, points)),
        this->Medium.accuracy.basis, forces(points, Eigen::all),
        velocities.rows() == 0 ? Points() : Points(velocities(points, Eigen::all)),
        this->Medium.fluid.viscosity, this->Ratios[v], this->Medium.wall);
    }
  }

  vesicle::FlowField::Flow At(const Points& points) const
  {
    const Points at_rest = Points::Zero(points.rows(), 3);
    const Points imposed = this->Medium.flow ? this->Medium.flow->velocities(points) : at_rest;
    if (this->Vesicles.size() == 1)
    {
      return this->Vesicles.front().at(points, imposed);
    }
    vesicle::FlowField::Flow sum{ imposed, std::vector<unsigned char>(points.rows(), 0) };
    Eigen::VectorXd ratio = Eigen::VectorXd::Ones(points.rows()); // of the fluid that a point is in
    for (std::size_t v = 0; v < this->Vesicles.size(); ++v)
    {
      const auto own = this->Vesicles[v].at(points, at_rest);
      for (Eigen::Index i = 0; i < points.rows(); ++i)
      {
        const bool inside = own.inside[i] != 0;
        sum.velocity.row(i) += (inside ? this->Ratios[v] : 1) * own.velocity.row(i);
        if (inside)
        {
          sum.inside[i] = 1;
          ratio[i] = this->Ratios[v];
        }
      }
    }
    for (Eigen::Index i = 0; i < points.rows(); ++i)
    {
      sum.velocity.row(i) *= ratio[i] > 0 ? 1 / ratio[i] : 0;
    }
    if (this->Medium.wall)
    {
      vesicle::rest_behind(*this->Medium.wall, points, sum.velocity);
    }
    return sum;
  }

private:
  static vtkSmartPointer<vtkPolyData> SurfaceOf(vtkDataObject* source)
  {
    return vesicle::without_ghosts(vesicle::triangulated(source, "source"));
  }

  /// One for each, or one for all.
  void ReadRatios(std::size_t vesicles)
  {
    this->Ratios.assign(vesicles, this->Medium.fluid.viscosity_ratio);
    const auto& others = this->Medium.companions;
    if (!others.empty() && others.size() + 1 != vesicles)
    {
      throw vesicle::InputError(
        fmt::format("the source has {} vesicles, and field data Viscosity_Ratio for {}", vesicles,
          others.size() + 1));
    }
    for (std::size_t v = 0; v < others.size(); ++v)
    {
      this->Ratios[v + 1] = others[v].viscosity_ratio;
    }
  }

  vtkSmartPointer<vtkPolyData> Surface;
  vesicle::Scene Medium;
  std::vector<double> Ratios; ///< λ of each vesicle
  std::vector<vesicle::TwoFluidFlow> Vesicles;
};

Points points_of(vtkDataSet* data, vtkIdType first, vtkIdType count)
{
  Points points(count, 3);
  for (vtkIdType i = 0; i < count; ++i)
  {
    data->GetPoint(first + i, points.row(i).data());
  }
  return points;
}

}

vtkStandardNewMacro(vtkVesicleProbeFilter);

vtkVesicleProbeFilter::vtkVesicleProbeFilter()
{
  this->SetNumberOfInputPorts(2);
}

void vtkVesicleProbeFilter::SetSourceData(vtkDataObject* source)
{
  this->SetInputDataObject(1, source);
}

void vtkVesicleProbeFilter::SetSourceConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

vtkDataObject* vtkVesicleProbeFilter::GetSource()
{
  return this->GetNumberOfInputConnections(1) > 0 ? this->GetInputDataObject(1, 0) : nullptr;
}

int vtkVesicleProbeFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  this->Superclass::FillInputPortInformation(port, info);
  if (port == 1)
  {
    vesicle::take_surfaces_together(info);
  }
  return 1;
}

int vtkVesicleProbeFilter::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* source = inputs[1]->GetInformationObject(0);
  vtkInformation* output = outputs->GetInformationObject(0);
  output->CopyEntry(source, Pipeline::TIME_STEPS());
  output->CopyEntry(source, Pipeline::TIME_RANGE());
  return 1;
}

int vtkVesicleProbeFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  vesicle::request_whole(inputs[1]);
  return 1;
}

int vtkVesicleProbeFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataSet* input = vtkDataSet::GetData(inputs[0]);
  vtkDataObject* source = vtkDataObject::GetData(inputs[1]);
  vtkDataSet* output = vtkDataSet::GetData(outputs);
  if (!input || !output)
  {
    vtkErrorMacro(<< "the input has no points: a block of it is no data set");
    return 0;
  }
  output->CopyStructure(input);
  output->GetPointData()->PassData(input->GetPointData());
  output->GetCellData()->PassData(input->GetCellData());
  output->GetFieldData()->PassData(input->GetFieldData());
  if (source->GetInformation()->Has(vtkDataObject::DATA_TIME_STEP()))
  {
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(),
      source->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()));
  }
  const vtkIdType count = input->GetNumberOfPoints();
  vtkNew<vtkDoubleArray> velocity;
  velocity->SetName("Velocity");
  velocity->SetNumberOfComponents(3);
  velocity->SetNumberOfTuples(count);
  vesicle::label(velocity);
  vtkNew<vtkUnsignedCharArray> inside;
  inside->SetName("Inside");
  inside->SetNumberOfTuples(count);
  try
  {
    const Flow flow(source);
    for (vtkIdType first = 0; first < count && !this->GetAbortExecute(); first += block_size)
    {
      const vtkIdType size = std::min(block_size, count - first);
      const auto block = flow.At(points_of(input, first, size));
      std::copy_n(block.velocity.data(), 3 * size, velocity->GetPointer(3 * first));
      std::copy_n(block.inside.data(), size, inside->GetPointer(first));
      this->UpdateProgress(static_cast<double>(first + size) / static_cast<double>(count));
    }
  }
  catch (const std::exception& error)
  {
    output->Initialize();
    vtkErrorMacro(<< error.what());
    return 0;
  }
  if (this->GetAbortExecute())
  {
    output->Initialize();
    return 1;
  }
  output->GetPointData()->AddArray(velocity);
  output->GetPointData()->AddArray(inside);
  output->GetPointData()->SetActiveVectors("Velocity");
  return 1;
}

void vtkVesicleProbeFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Source: " << this->GetSource() << '\n';
}
