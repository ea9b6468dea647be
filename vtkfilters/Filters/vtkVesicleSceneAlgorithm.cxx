#include "vtkVesicleSceneAlgorithm.h"

#include "SceneNumbers.h"
#include "SurfacePorts.h"

#include "solver/Errors.h"
#include "solver/flow/FieldFlow.h"
#include "solver/flow/FlowKinds.h"
#include "solver/flow/FlowNumbers.h"
#include "solver/scene/SceneNames.h"
#include "solver/scene/SceneSchema.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <string>

namespace
{

using vesicle::Scene;

std::string flow_title(int kind)
{
  return kind == 0 ? "at rest" : vesicle::flow_kinds().at(kind - 1)->title;
}

void require(bool condition, const char* what)
{
  if (!condition)
  {
    throw vesicle::InputError(what);
  }
}

std::filesystem::path absolute_path(const char* file, const char* otherwise)
{
  require(file && *file, otherwise);
  return std::filesystem::absolute(file).lexically_normal();
}

}

vtkVesicleSceneAlgorithm::vtkVesicleSceneAlgorithm()
{
  this->SetNumberOfInputPorts(2);
}

vtkVesicleSceneAlgorithm::~vtkVesicleSceneAlgorithm()
{
  this->SetReferenceFile(nullptr);
  this->SetFlowFile(nullptr);
}

void vtkVesicleSceneAlgorithm::SetVelocityFieldData(vtkDataObject* field)
{
  this->SetInputDataObject(1, field);
}

void vtkVesicleSceneAlgorithm::SetVelocityFieldConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

vtkDataObject* vtkVesicleSceneAlgorithm::GetVelocityField()
{
  return this->GetNumberOfInputConnections(1) > 0 ? this->GetInputDataObject(1, 0) : nullptr;
}

int vtkVesicleSceneAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  this->Superclass::FillInputPortInformation(port, info);
  if (port == 0)
  {
    vesicle::take_surfaces_together(info);
  }
  else
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

Scene vtkVesicleSceneAlgorithm::MakeScene()
{
  require(
    vesicle::scene_key("fluid", "viscosity").allows(this->Viscosity), "Viscosity must be above 0");
  require(vesicle::scene_key("fluid", "viscosity_ratio").allows(this->ViscosityRatio),
    "ViscosityRatio must be 0 or more");
  require(vesicle::scene_key("membrane", "surface_viscosity").allows(this->SurfaceViscosity),
    "SurfaceViscosity must be 0 or more");
  require(
    this->FlowKind != Poiseuille || vesicle::scene_key("flow", "radius").allows(this->FlowRadius),
    "FlowRadius must be above 0");
  require(this->BondNumber == 0 || this->BendingRigidity > 0,
    "a BondNumber takes a BendingRigidity above 0; without bending give DensityDifference");
  Scene scene;
  const Scene::Preset preset = vesicle::preset_names[this->Preset].choice; // in the same order
  scene.accuracy = Scene::preset(preset);
  scene.time.tolerance = Scene::preset_tolerance(preset);
  if (this->BendingRigidity > 0)
  {
    scene.membrane.bending_rigidity = this->BendingRigidity;
    scene.membrane.spontaneous_curvature = this->SpontaneousCurvature;
    if (this->AreaDifferenceStiffness > 0)
    {
      scene.membrane.area_difference_stiffness = this->AreaDifferenceStiffness;
      scene.membrane.area_difference = this->AreaDifference;
    }
  }
  scene.membrane.incompressible = this->Incompressible;
  if (this->ShearModulus != 0)
  {
    this->MakeElastic(scene);
  }
  scene.fluid.viscosity = this->Viscosity;
  scene.fluid.viscosity_ratio = this->ViscosityRatio;
  require(this->ViscosityRatio == 1 || scene.accuracy.basis == Scene::Basis::loop,
    "a ViscosityRatio other than 1 takes the preset balanced or accurate");
  if (this->Wall)
  {
    scene.wall =
      vesicle::Wall{ vesicle::Vector3(this->WallPoint), vesicle::Vector3(this->WallNormal) };
    require(scene.wall->normal.norm() > 0, "WallNormal must not be 0");
    scene.wall->normal.normalize();
  }
  scene.membrane.surface_viscosity = this->SurfaceViscosity;
  require(this->SurfaceViscosity == 0 || scene.accuracy.basis == Scene::Basis::loop,
    "a SurfaceViscosity above 0 takes the preset balanced or accurate");
  scene.flow = this->MakeFlow();
  if (this->BondNumber != 0)
  {
    scene.gravity = { this->BondNumber, 0, 0 };
  }
  else if (this->DensityDifference != 0 && this->Acceleration != 0)
  {
    scene.gravity = { {}, this->DensityDifference, this->Acceleration };
  }
  return scene;
}

void vtkVesicleSceneAlgorithm::MakeElastic(vesicle::Scene& scene) const
{
  const auto allows = [](const char* key, double value)
  { return vesicle::scene_key("membrane", key).allows(value); };
  require(allows("shear_modulus", this->ShearModulus), "ShearModulus must be 0 or more");
  require(allows("dilation_modulus", this->DilationModulus), "DilationModulus must be above 0");
  require(allows("prestretch", this->Prestretch), "Prestretch must be above 0");
  require(scene.accuracy.basis == Scene::Basis::loop,
    "a ShearModulus above 0 takes the preset balanced or accurate");
  Scene::Membrane& membrane = scene.membrane;
  membrane.shear_modulus = this->ShearModulus;
  membrane.elasticity = vesicle::elasticity_names[this->Elasticity].choice; // in the same order
  membrane.dilation_modulus = this->DilationModulus;
  using Of = Scene::Membrane::Reference;
  membrane.reference =
    std::array{ Of::start, Of::sphere, Of::file }[this->Reference]; // in References' order
  if (this->Reference == FileReference)
  {
    membrane.reference_file =
      absolute_path(this->ReferenceFile, "Reference FileReference takes a ReferenceFile");
  }
  membrane.prestretch = this->Prestretch;
  scene.accuracy.mesh_motion = Scene::MeshMotion::material;
}

std::shared_ptr<const vesicle::ImposedFlow> vtkVesicleSceneAlgorithm::MakeFlow()
{
  const std::map<std::string, const double*> properties{ { "rate", &this->FlowRate },
    { "velocity", this->FlowVelocity }, { "radius", &this->FlowRadius },
    { "center", this->FlowCenter }, { "axis", this->FlowAxis }, { "type", &this->FlowType } };
  if (this->FlowKind == VelocityField)
  {
    const auto field = std::make_shared<vesicle::FieldFlow>();
    field->file = absolute_path(this->FlowFile, "FlowKind VelocityField takes a FlowFile").string();
    return field;
  }
  return vesicle::flow_of(this->FlowKind,
    [&](const std::string& parameter, std::span<double> values)
    { std::copy_n(properties.at(parameter), values.size(), values.begin()); });
}

void vtkVesicleSceneAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, const double* v)
  { os << indent << name << ": " << v[0] << ' ' << v[1] << ' ' << v[2] << '\n'; };
  os << indent << "BendingRigidity: " << this->BendingRigidity << '\n';
  os << indent << "SpontaneousCurvature: " << this->SpontaneousCurvature << '\n';
  os << indent << "AreaDifferenceStiffness: " << this->AreaDifferenceStiffness << '\n';
  os << indent << "AreaDifference: " << this->AreaDifference << '\n';
  os << indent << "Incompressible: " << (this->Incompressible ? "on" : "off") << '\n';
  os << indent << "ShearModulus: " << this->ShearModulus << '\n';
  os << indent << "Elasticity: " << vesicle::elasticity_names[this->Elasticity].name << '\n';
  os << indent << "DilationModulus: " << this->DilationModulus << '\n';
  os << indent << "Reference: " << std::array{ "start", "sphere", "file" }[this->Reference] << '\n';
  os << indent << "ReferenceFile: " << (this->ReferenceFile ? this->ReferenceFile : "(none)")
     << '\n';
  os << indent << "Prestretch: " << this->Prestretch << '\n';
  os << indent << "SurfaceViscosity: " << this->SurfaceViscosity << '\n';
  os << indent << "Viscosity: " << this->Viscosity << '\n';
  os << indent << "ViscosityRatio: " << this->ViscosityRatio << '\n';
  os << indent << "Wall: " << (this->Wall ? "on" : "off") << '\n';
  print("WallPoint", this->WallPoint);
  print("WallNormal", this->WallNormal);
  os << indent << "FlowKind: " << flow_title(this->FlowKind) << '\n';
  os << indent << "FlowRate: " << this->FlowRate << '\n';
  print("FlowVelocity", this->FlowVelocity);
  os << indent << "FlowRadius: " << this->FlowRadius << '\n';
  print("FlowCenter", this->FlowCenter);
  print("FlowAxis", this->FlowAxis);
  os << indent << "FlowType: " << this->FlowType << '\n';
  os << indent << "FlowFile: " << (this->FlowFile ? this->FlowFile : "(none)") << '\n';
  os << indent << "VelocityField: " << this->GetVelocityField() << '\n';
  os << indent << "BondNumber: " << this->BondNumber << '\n';
  os << indent << "DensityDifference: " << this->DensityDifference << '\n';
  os << indent << "Acceleration: " << this->Acceleration << '\n';
  os << indent << "Preset: " << vesicle::preset_names[this->Preset].name << '\n';
}
