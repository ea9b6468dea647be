#include "vtkVesicleStepper.h"

#include "MeshConversion.h"
#include "SceneMesh.h"
#include "SceneNumbers.h"
#include "SurfacePorts.h"
#include "VelocityFieldData.h"
#include "VelocityFieldFile.h"

#include "solver/Doing.h"
#include "solver/Errors.h"
#include "solver/Joined.h"
#include "solver/simulation/Simulation.h"
#include "solver/simulation/SystemOfScene.h"
#include "solver/scene/SceneFile.h"
#include "solver/simulation/Trajectory.h"
#include "solver/state/RunRows.h"

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
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"
#include "vtkTimeStamp.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace
{

using vesicle::Diagnostics;
using vesicle::Scene;
using vesicle::Simulation;
using vesicle::State;
using Moment = vesicle::Trajectory::Moment;
using Fields = std::map<std::string, Eigen::MatrixXd>;
using Pipeline = vtkStreamingDemandDrivenPipeline;

/// Where between two states a moment lies, 0 to 1.
double share(const Moment& moment)
{
  return moment.after
    ? (moment.time - moment.before->time) / (moment.after->time - moment.before->time)
    : 0;
}

Fields fields_at(Simulation& simulation, const Moment& moment)
{
  Fields fields = simulation.fields(*moment.before);
  if (moment.after)
  {
    const double s = share(moment);
    for (auto& [name, values] : simulation.fields(*moment.after))
    {
      fields[name] = (1 - s) * fields[name] + s * values;
    }
    fields["Normals"].rowwise().normalize();
  }
  return fields;
}

vesicle::Points points_at(Simulation& simulation, const Moment& moment)
{
  return moment.after ? simulation.points_between(*moment.before, *moment.after, moment.time)
                      : simulation.points(*moment.before);
}

/// The field data of the output contract.
constexpr std::pair<const char*, double Diagnostics::*> numbers[] = { { "Area",
                                                                        &Diagnostics::area },
  { "Volume", &Diagnostics::volume }, { "Reduced_Volume", &Diagnostics::reduced_volume },
  { "Bending_Energy", &Diagnostics::bending_energy }, { "Area_Drift", &Diagnostics::area_drift },
  { "Volume_Drift", &Diagnostics::volume_drift } };

/// The parts of a surface, each a vesicle of the scene.
std::vector<vesicle::StartMesh> parts_of(vtkPolyData* surface)
{
  const vesicle::TriangleMesh mesh = vesicle::to_mesh(surface);
  std::vector<vesicle::StartMesh> parts;
  for (const std::vector<int>& points : vesicle::vesicle_points(surface))
  {
    parts.push_back({ vesicle::part_with(mesh, points), {} });
  }
  return parts;
}

/// Arrays of the start go with points and triangles that stay where they are.
bool lies_in_order(vtkPolyData* surface)
{
  int next = 0;
  for (const std::vector<int>& points : vesicle::vesicle_points(surface))
  {
    for (const int point : points)
    {
      if (point != next++)
      {
        return false;
      }
    }
  }
  return true;
}

vtkSmartPointer<vtkTable> table_of(const std::vector<Diagnostics>& vesicles)
{
  auto table = vtkSmartPointer<vtkTable>::New();
  const auto names = vesicle::run_columns(vesicle::row_kind(vesicles));
  const auto row = vesicle::run_row(vesicles);
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(names[i].c_str());
    for (std::size_t at = i; at < row.size(); at += names.size())
    {
      column->InsertNextValue(row[at].value_or(std::numeric_limits<double>::quiet_NaN()));
    }
    table->AddColumn(column);
  }
  return table;
}

}

struct vtkVesicleStepper::Internals
{
  std::string SceneFileName;
  std::string SceneText;
  std::vector<std::string> Overrides;
  std::optional<Scene> GivenScene;
  std::optional<State> GivenState;
  std::string ErrorMessage;

  vtkTimeStamp Changed; // the settings above; MTime also moves with SetAbortExecute

  // What the settings above led to.
  Scene CurrentScene;
  std::string PropertiesText; // the scene of the properties as TOML
  // Without what the second input says, and with it.
  std::shared_ptr<const vesicle::ImposedFlow> SceneFlow;
  std::string SceneFieldNotes, FieldNotes; // on the velocity field
  vtkMTimeType SceneTime = 0;
  std::unique_ptr<Simulation> Sim;
  vtkSmartPointer<vtkPolyData> Start; // the input's membrane, whose indices have been looked at
  std::unique_ptr<vesicle::Trajectory> Path;
  vtkMTimeType SimulationTime = 0;
  std::array<vtkDataObject*, 2> Inputs{}; // that it began with

  std::vector<Diagnostics> LastDiagnostics;
  std::int64_t DiagnosedStep = -1;
  vtkSmartPointer<vtkTable> LastTable;
  std::string Settings;

  /// A scene that isn't the properties'.
  bool HasScene() const
  {
    return this->GivenScene || !this->SceneFileName.empty() || !this->SceneText.empty();
  }

  Scene ReadScene() const
  {
    if (this->GivenScene)
    {
      return *this->GivenScene;
    }
    return this->SceneFileName.empty()
      ? vesicle::parse_scene(this->SceneText, "SceneText", ".", this->Overrides)
      : vesicle::read_scene(this->SceneFileName, this->Overrides);
  }

  void ReadField(vtkDataObject* field)
  {
    this->FieldNotes = this->SceneFieldNotes;
    this->CurrentScene.flow = vesicle::flow_with_field(this->SceneFlow, field, this->FieldNotes);
  }

  std::vector<vesicle::StartMesh> StartMeshes(vtkPolyData* start) const
  {
    if (!start)
    {
      return vesicle::start_meshes_of(this->CurrentScene);
    }
    if (this->CurrentScene.vesicles() == 1)
    {
      return { { vesicle::to_mesh(start), {}, vesicle::reference_mesh_of(this->CurrentScene) } };
    }
    if (!lies_in_order(start))
    {
      throw vesicle::InputError(
        "the points of the start shape's vesicles must lie one vesicle after "
        "the other, as frames of a run and vtkAppendPolyData have them");
    }
    std::vector<vesicle::StartMesh> parts = parts_of(start);
    for (std::size_t v = 0; v < parts.size() && v < this->CurrentScene.vesicles(); ++v)
    {
      parts[v].reference = vesicle::reference_mesh_of(this->CurrentScene.alone(v));
    }
    return parts;
  }

  void StartAnew(vtkPolyData* start, int cache_size)
  {
    this->Path.reset();
    this->Sim.reset();
    std::vector<vesicle::StartMesh> meshes = this->StartMeshes(start);
    meshes.front().notes = vesicle::lines({ meshes.front().notes, this->FieldNotes });
    this->Sim = std::make_unique<Simulation>(this->CurrentScene, meshes);
    if (this->GivenState)
    {
      this->Sim->require_own(*this->GivenState);
    }
    State first = this->GivenState ? *this->GivenState : this->Sim->start();
    this->Path = std::make_unique<vesicle::Trajectory>(*this->Sim, std::move(first), cache_size);
    this->DiagnosedStep = -1;
  }

  const std::vector<Diagnostics>& Diagnose()
  {
    const State& last = this->Path->last();
    if (this->DiagnosedStep != last.step)
    {
      this->LastDiagnostics = this->Sim->diagnose_all(last);
      this->DiagnosedStep = last.step;
    }
    return this->LastDiagnostics;
  }

  std::vector<Diagnostics> Diagnose(const State& state)
  {
    return state.step == this->Path->last().step ? this->Diagnose()
                                                 : this->Sim->diagnose_all(state);
  }

  void AddNumbers(const Moment& moment, vtkPolyData* output)
  {
    vtkFieldData* to = output->GetFieldData();
    vesicle::add_number(to, "TimeValue", moment.time);
    const auto now = this->Diagnose(*moment.before);
    const auto later = moment.after ? this->Diagnose(*moment.after) : now;
    for (const auto& [name, member] : numbers)
    {
      std::vector<double> values;
      for (std::size_t v = 0; v < now.size(); ++v)
      {
        const double value = now[v].*member;
        values.push_back(moment.after ? value + share(moment) * (later[v].*member - value) : value);
      }
      vesicle::add_numbers(to, name, values);
    }
    vesicle::add_medium(this->CurrentScene, moment.time, to);
  }

  /// `start` passes its arrays on; nullptr: none.
  void Deliver(const Moment& moment, vtkPolyData* start, vtkPolyData* output)
  {
    if (start)
    {
      output->ShallowCopy(start);
    }
    const vesicle::VesicleState& vesicle = moment.before->vesicles[0];
    if (start && this->Sim->vesicles() == 1 &&
      !vesicle::same_triangles(vesicle.triangles, this->Sim->start_mesh().triangles))
    {
      output->GetPointData()->Initialize(); // the start's, on a mesh laid anew
      output->GetCellData()->Initialize();
    }
    output->SetPoints(vesicle::to_vtk_points(points_at(*this->Sim, moment)));
    output->SetPolys(this->Sim->vesicles() == 1
        ? vesicle::to_cells(vesicle.triangles)
        : vesicle::to_cells(this->Sim->start_mesh().triangles));
    vesicle::add_fields(fields_at(*this->Sim, moment), this->CurrentScene, output);
    if (this->Sim->vesicles() > 1)
    {
      vesicle::add_vesicle_ids(this->Sim->vesicle_ids(*moment.before), output);
    }
    this->AddNumbers(moment, output);
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), moment.time);
  }
};

vtkStandardNewMacro(vtkVesicleStepper);

vtkVesicleStepper::vtkVesicleStepper() : Internal(std::make_unique<Internals>())
{
  this->Internal->Changed.Modified();
}

vtkVesicleStepper::~vtkVesicleStepper() = default;

void vtkVesicleStepper::SettingsChanged()
{
  this->Internal->Changed.Modified();
  this->Modified();
}

void vtkVesicleStepper::SetSceneFileName(const char* name)
{
  this->Internal->SceneFileName = name ? name : "";
  this->Internal->GivenScene.reset();
  this->SettingsChanged();
}

void vtkVesicleStepper::SetSceneText(const char* text)
{
  this->Internal->SceneText = text ? text : "";
  this->Internal->GivenScene.reset();
  this->SettingsChanged();
}

const char* vtkVesicleStepper::GetSceneText()
{
  return this->Internal->SceneText.c_str();
}

const char* vtkVesicleStepper::GetSceneFileName()
{
  return this->Internal->SceneFileName.c_str();
}

void vtkVesicleStepper::AddOverride(const char* setting)
{
  this->Internal->Overrides.push_back(setting ? setting : "");
  this->SettingsChanged();
}

void vtkVesicleStepper::RemoveAllOverrides()
{
  this->Internal->Overrides.clear();
  this->SettingsChanged();
}

int vtkVesicleStepper::GetNumberOfOverrides()
{
  return static_cast<int>(this->Internal->Overrides.size());
}

const char* vtkVesicleStepper::GetErrorMessage()
{
  return this->Internal->ErrorMessage.c_str();
}

double vtkVesicleStepper::GetStateTime()
{
  return this->GetState() ? this->GetState()->time : 0;
}

vtkIdType vtkVesicleStepper::GetNumberOfSteps()
{
  return this->GetState() ? this->GetState()->step : 0;
}

bool vtkVesicleStepper::GetFinished()
{
  return this->Internal->Path && this->Internal->Path->finished();
}

double vtkVesicleStepper::GetNextOutputTime()
{
  const State* state = this->GetState();
  return state ? this->Internal->Sim->schedule().next(*state).value_or(VTK_DOUBLE_MAX)
               : VTK_DOUBLE_MAX;
}

vtkTable* vtkVesicleStepper::GetDiagnosticsTable()
{
  this->Internal->LastTable = this->GetState() ? table_of(this->Internal->Diagnose()) : nullptr;
  return this->Internal->LastTable;
}

void vtkVesicleStepper::CopyState(vtkPolyData* output)
{
  const State* state = this->GetState();
  if (!state)
  {
    vtkErrorMacro(<< "there is no state before the first update");
    return;
  }
  const Moment moment{ state->time, state, nullptr };
  this->Guarded([&] { this->Internal->Deliver(moment, nullptr, output); });
}

const char* vtkVesicleStepper::GetSettings()
{
  auto& internal = *this->Internal;
  internal.Settings = internal.SceneTime > 0 ? vesicle::write_scene(internal.CurrentScene) : "";
  return internal.Settings.c_str();
}

void vtkVesicleStepper::SetScene(const Scene& scene)
{
  this->Internal->GivenScene = scene;
  this->SettingsChanged();
}

void vtkVesicleStepper::SetState(const State& state)
{
  this->Internal->GivenState = state;
  this->SettingsChanged();
}

Simulation* vtkVesicleStepper::GetSimulation()
{
  return this->Internal->Sim.get();
}

const State* vtkVesicleStepper::GetState() const
{
  return this->Internal->Path ? &this->Internal->Path->last() : nullptr;
}

const Diagnostics& vtkVesicleStepper::GetDiagnostics() const
{
  return this->Internal->Diagnose().front();
}

const std::vector<Diagnostics>& vtkVesicleStepper::GetAllDiagnostics() const
{
  return this->Internal->Diagnose();
}

int vtkVesicleStepper::FillInputPortInformation(int port, vtkInformation* info)
{
  this->Superclass::FillInputPortInformation(port, info);
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

void vtkVesicleStepper::ForgetFailure()
{
  this->ErrorCategory = NoFailure;
  this->Internal->ErrorMessage.clear();
}

template<class Work>
bool vtkVesicleStepper::Guarded(const Work& work)
{
  try
  {
    work();
    return true;
  }
  catch (const vesicle::NumericalError& error)
  {
    this->ErrorCategory = NumericalFailure;
    this->Internal->ErrorMessage = error.what();
  }
  catch (const vesicle::UnforeseenError& error)
  {
    this->ErrorCategory = NumericalFailure; // it can't go on either, and the last state is good
    this->Internal->ErrorMessage = error.what();
  }
  catch (const vesicle::IoError& error)
  {
    this->ErrorCategory = IoFailure;
    this->Internal->ErrorMessage = error.what();
  }
  catch (const std::exception& error)
  {
    this->ErrorCategory = InputFailure;
    this->Internal->ErrorMessage = error.what();
  }
  vtkErrorMacro(<< this->Internal->ErrorMessage);
  return false;
}

Scene vtkVesicleStepper::SceneOfProperties()
{
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    throw vesicle::InputError("neither a scene nor a start shape: set SceneFileName or SceneText, "
                              "or connect a start shape (vtkVesicleSource)");
  }
  if (!(this->OutputEvery > 0))
  {
    throw vesicle::InputError("OutputEvery must be above 0");
  }
  Scene scene = this->MakeScene();
  scene.time.output_every = this->OutputEvery;
  if (this->EndTime > 0)
  {
    scene.time.end = this->EndTime;
  }
  if (this->TimeStep > 0)
  {
    scene.time.step = this->TimeStep;
  }
  if (this->Tolerance > 0)
  {
    scene.time.tolerance = this->Tolerance;
  }
  return scene;
}

void vtkVesicleStepper::ReadScene()
{
  auto& internal = *this->Internal;
  if (!internal.HasScene())
  {
    // What the properties say is compared as text: then it doesn't matter which one was set.
    const std::string text = vesicle::write_scene(this->SceneOfProperties());
    if (text != internal.PropertiesText)
    {
      internal.PropertiesText = text;
      internal.Changed.Modified();
    }
  }
  if (internal.SceneTime >= internal.Changed)
  {
    return;
  }
  internal.CurrentScene = internal.HasScene()
    ? internal.ReadScene()
    : vesicle::parse_scene(internal.PropertiesText, "properties", ".", internal.Overrides);
  internal.SceneFieldNotes.clear();
  internal.CurrentScene =
    vesicle::with_velocity_field(std::move(internal.CurrentScene), internal.SceneFieldNotes);
  internal.SceneFlow = internal.CurrentScene.flow;
  internal.SceneTime = internal.Changed;
}

void vtkVesicleStepper::Prepare(vtkDataObject* start, vtkDataObject* field)
{
  auto& internal = *this->Internal;
  this->ReadScene();
  vtkMTimeType needed = internal.Changed.GetMTime();
  for (vtkDataObject* input : { start, field })
  {
    needed = std::max(needed, input ? input->GetMTime() : vtkMTimeType(0));
  }
  const std::array inputs{ start, field };
  if (internal.Path && internal.SimulationTime >= needed && internal.Inputs == inputs)
  {
    return;
  }
  const auto membrane = start ? vesicle::membrane_of(start) : nullptr;
  if (membrane && !internal.HasScene())
  {
    internal.CurrentScene.companions.assign(
      std::max<std::size_t>(vesicle::vesicle_points(membrane).size(), 1) - 1,
      internal.CurrentScene.companion());
  }
  internal.ReadField(field);
  internal.StartAnew(membrane, this->CacheSize);
  internal.Start = membrane;
  internal.SimulationTime = needed;
  internal.Inputs = inputs;
  if (!internal.Sim->notes().empty())
  {
    vtkWarningMacro(<< internal.Sim->notes());
  }
}

int vtkVesicleStepper::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  // The time that is asked for is this simulation's, not the start shape's or the field's.
  vesicle::request_start(inputs[0]);
  vesicle::request_start(inputs[1]);
  return 1;
}

int vtkVesicleStepper::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  this->ForgetFailure();
  if (!this->Guarded([&] { vesicle::doing("reading the scene", [&] { this->ReadScene(); }); }))
  {
    return 0;
  }
  vtkInformation* info = outputs->GetInformationObject(0);
  const auto& time = this->Internal->CurrentScene.time;
  const auto& state = this->Internal->GivenState;
  const double start = state ? state->time : 0;
  std::optional<double> end = time.end;
  if (!end && this->GetFinished())
  {
    end = this->GetStateTime();
  }
  const double range[2] = { start, end ? std::max(*end, start) : VTK_DOUBLE_MAX };
  info->Set(Pipeline::TIME_RANGE(), range, 2);
  if (end)
  {
    const auto times = vesicle::schedule_of(this->Internal->CurrentScene).between(start, *end);
    info->Set(Pipeline::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
  }
  else
  {
    info->Remove(Pipeline::TIME_STEPS());
  }
  return 1;
}

void vtkVesicleStepper::AdvanceTo(double time)
{
  auto& path = *this->Internal->Path;
  const double from = path.last().time;
  while (!path.finished() && path.last().time < time &&
    !vesicle::same_time(path.last().time, time) && !this->GetAbortExecute())
  {
    vesicle::doing(
      fmt::format("the step after t = {:.6g}", path.last().time), [&] { path.advance(); });
    this->InvokeEvent(StepAcceptedEvent);
    this->ShareProgress(from, time);
  }
}

void vtkVesicleStepper::ShareProgress(double from, double to)
{
  const double done = this->GetStateTime() - from;
  this->UpdateProgress(to < VTK_DOUBLE_MAX ? std::min(1.0, done / (to - from)) : 0.5);
}

int vtkVesicleStepper::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  vtkInformation* info = outputs->GetInformationObject(0);
  auto& internal = *this->Internal;
  vtkDataObject* start = vtkDataObject::GetData(inputs[0]);
  this->ForgetFailure();
  if (!vesicle::is_first_piece(outputs))
  {
    return 1;
  }
  if (auto* surface = vtkDataSet::SafeDownCast(start); surface && surface->GetNumberOfCells() == 0)
  {
    vtkWarningMacro(<< "the start shape is empty: there is nothing to simulate");
    return 1;
  }
  if (!this->Guarded(
        [&]
        {
          vesicle::doing("preparing the simulation",
            [&] { this->Prepare(start, vtkDataObject::GetData(inputs[1])); });
        }))
  {
    return 0;
  }
  const double time = info->Has(Pipeline::UPDATE_TIME_STEP())
    ? info->Get(Pipeline::UPDATE_TIME_STEP())
    : internal.Path->start_time();
  this->Guarded([&] { this->AdvanceTo(time); }); // after a failure the last good state is delivered
  return this->Guarded(
    [&]
    {
      vesicle::doing(fmt::format("the surface at t = {:.6g}", time),
        [&] {
          internal.Deliver(internal.Path->at(time), start ? internal.Start.Get() : nullptr, output);
        });
    });
}

void vtkVesicleStepper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SceneFileName: " << this->GetSceneFileName() << '\n';
  os << indent << "SceneText: " << this->GetSceneText() << '\n';
  for (const auto& setting : this->Internal->Overrides)
  {
    os << indent << "Override: " << setting << '\n';
  }
  os << indent << "EndTime: " << this->EndTime << '\n';
  os << indent << "OutputEvery: " << this->OutputEvery << '\n';
  os << indent << "TimeStep: " << this->TimeStep << '\n';
  os << indent << "Tolerance: " << this->Tolerance << '\n';
  os << indent << "CacheSize: " << this->CacheSize << '\n';
  os << indent << "ErrorCategory: " << this->ErrorCategory << '\n';
  os << indent << "ErrorMessage: " << this->GetErrorMessage() << '\n';
  os << indent << "StateTime: " << this->GetStateTime() << '\n';
  os << indent << "NumberOfSteps: " << this->GetNumberOfSteps() << '\n';
  os << indent << "Finished: " << (this->GetFinished() ? "yes" : "no") << '\n';
}
