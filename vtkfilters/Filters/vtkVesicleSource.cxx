#include "vtkVesicleSource.h"

#include "MeshConversion.h"
#include "SceneNumbers.h"

#include "solver/Errors.h"
#include "solver/mesh/MeshIntegrals.h"
#include "solver/mesh/shapes/ShapeRequest.h"
#include "solver/surface/StartShape.h"
#include "solver/surface/SurfaceMeasures.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace
{

using Kind = vesicle::ShapeRequest::Kind;
using vesicle::SurfaceBasis;

constexpr std::array kinds{ Kind::sphere, Kind::prolate, Kind::oblate, Kind::ellipsoid,
  Kind::discocyte, Kind::perturbed, Kind::stomatocyte }; // in the order of vtkVesicleSource::Shapes

}

struct vtkVesicleSource::ModeList
{
  std::vector<vesicle::ShapeMode> Items;
  std::string ShapeName; // what GetShapeName points to
};

vtkStandardNewMacro(vtkVesicleSource);

vtkVesicleSource::vtkVesicleSource() : Modes(std::make_unique<ModeList>())
{
  this->SetNumberOfInputPorts(0);
}

vtkVesicleSource::~vtkVesicleSource() = default;

void vtkVesicleSource::SetShapeByName(const char* name)
{
  try
  {
    const Kind kind = vesicle::shape_kind(name ? name : "");
    for (int i = 0; i < static_cast<int>(kinds.size()); ++i)
    {
      if (kinds[i] == kind)
      {
        this->SetShape(i);
      }
    }
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
  }
}

const char* vtkVesicleSource::GetShapeName()
{
  this->Modes->ShapeName = vesicle::shape_name(kinds[this->Shape]);
  return this->Modes->ShapeName.c_str();
}

void vtkVesicleSource::AddMode(int l, int m, double amplitude)
{
  this->Modes->Items.push_back({ l, m, amplitude });
  this->Modified();
}

void vtkVesicleSource::AddMode(const double mode[3])
{
  this->AddMode(
    static_cast<int>(std::lround(mode[0])), static_cast<int>(std::lround(mode[1])), mode[2]);
}

void vtkVesicleSource::RemoveAllModes()
{
  this->Modes->Items.clear();
  this->Modified();
}

int vtkVesicleSource::GetNumberOfModes()
{
  return static_cast<int>(this->Modes->Items.size());
}

int vtkVesicleSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vesicle::ShapeRequest request;
  request.kind = kinds[this->Shape];
  request.triangles = this->Triangles;
  if (this->ReducedVolume > 0)
  {
    request.reduced_volume = this->ReducedVolume;
  }
  std::copy_n(this->SemiAxes, 3, request.semi_axes.begin());
  request.modes = this->Modes->Items;
  const vesicle::Vector3 axis(this->Axis);
  const auto basis = this->Basis == Linear ? SurfaceBasis::linear : SurfaceBasis::loop;
  try
  {
    if (!(this->Radius > 0) || !(axis.norm() > 0))
    {
      throw vesicle::InputError("Radius must be above 0 and Axis must have a direction");
    }
    vesicle::TriangleMesh mesh = vesicle::make_start_shape(request, basis);
    const std::string warning = vesicle::start_shape_warning(request, basis, mesh);
    if (!warning.empty())
    {
      vtkWarningMacro(<< warning);
    }
    const auto [area, volume, energy] = vesicle::surface_measures(basis, mesh);
    vesicle::place(mesh, this->Radius, vesicle::turn_z_to(axis), vesicle::Vector3(this->Center));
    const auto surface = vesicle::to_polydata(mesh);
    vesicle::add_surface(basis, vesicle::reduced_volume(area, volume), surface->GetFieldData());
    vtkPolyData::GetData(outputs)->ShallowCopy(surface);
    return 1;
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return 0;
  }
}

void vtkVesicleSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, const double* v)
  { os << indent << name << ": " << v[0] << ' ' << v[1] << ' ' << v[2] << '\n'; };
  os << indent << "Shape: " << this->GetShapeName() << '\n';
  os << indent << "Basis: " << (this->Basis == Linear ? "linear" : "loop") << '\n';
  os << indent << "ReducedVolume: " << this->ReducedVolume << '\n';
  os << indent << "Triangles: " << this->Triangles << '\n';
  os << indent << "Radius: " << this->Radius << '\n';
  print("Axis", this->Axis);
  print("Center", this->Center);
  print("SemiAxes", this->SemiAxes);
  for (const auto& mode : this->Modes->Items)
  {
    os << indent << "Mode: " << mode.l << ' ' << mode.m << ' ' << mode.amplitude << '\n';
  }
}
