#include "vtkVesicleForceFilter.h"

#include "MeshConversion.h"
#include "SceneMesh.h"
#include "SceneNumbers.h"
#include "SurfacePorts.h"
#include "VelocityFieldData.h"
#include "VelocityFieldFile.h"

#include "solver/Joined.h"
#include "solver/Errors.h"
#include "solver/mesh/Preparation.h"
#include "solver/simulation/Simulation.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <map>
#include <string>
#include <vector>

namespace
{

using vesicle::Diagnostics;
using vesicle::Simulation;
using Vesicles = std::vector<std::vector<int>>; ///< the points of each

/// Rows and corners of the simulation's joined mesh are those of the vesicles one after the other.
std::vector<int> order_of(const Vesicles& vesicles)
{
  std::vector<int> order;
  for (const auto& points : vesicles)
  {
    order.insert(order.end(), points.begin(), points.end());
  }
  return order;
}

std::map<std::string, Eigen::MatrixXd> in_place(
  std::map<std::string, Eigen::MatrixXd> fields, const std::vector<int>& order)
{
  for (auto& [name, values] : fields)
  {
    const Eigen::MatrixXd joined = values;
    values(order, Eigen::all) = joined;
  }
  return fields;
}

/// Of each vesicle's triangles, as they were turned, in the order of the whole mesh.
vesicle::Triangles in_place(const std::vector<vesicle::Triangles>& of_vesicles,
  const Vesicles& vesicles, const vesicle::TriangleMesh& mesh)
{
  std::vector<std::size_t> owner(mesh.points.rows());
  for (std::size_t v = 0; v < vesicles.size(); ++v)
  {
    for (const int point : vesicles[v])
    {
      owner[point] = v;
    }
  }
  std::vector<Eigen::Index> next(vesicles.size(), 0);
  vesicle::Triangles triangles(mesh.triangles.rows(), 3);
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
  {
    const std::size_t v = owner[mesh.triangles(t, 0)];
    const auto own = of_vesicles[v].row(next[v]++);
    for (int k = 0; k < 3; ++k)
    {
      triangles(t, k) = vesicles[v][own[k]];
    }
  }
  return triangles;
}

void add_geometry(const std::vector<Diagnostics>& all, vtkFieldData* to)
{
  const auto add = [&](const char* name, double Diagnostics::*member)
  {
    std::vector<double> values;
    for (const Diagnostics& vesicle : all)
    {
      values.push_back(vesicle.*member);
    }
    vesicle::add_numbers(to, name, values);
  };
  add("Area", &Diagnostics::area);
  add("Volume", &Diagnostics::volume);
  add("Reduced_Volume", &Diagnostics::reduced_volume);
  add("Bending_Energy", &Diagnostics::bending_energy);
}

void add_vesicles(const Vesicles& vesicles, vtkPolyData* output)
{
  std::vector<int> ids(output->GetNumberOfPoints());
  for (std::size_t v = 0; v < vesicles.size(); ++v)
  {
    for (const int point : vesicles[v])
    {
      ids[point] = static_cast<int>(v);
    }
  }
  vesicle::add_vesicle_ids(ids, output);
}

void solve(const vesicle::Scene& scene, Simulation& simulation, const Vesicles& vesicles,
  vtkPolyData* output)
{
  const vesicle::State state = simulation.instant();
  const std::vector<int> order = order_of(vesicles);
  const vesicle::Triangles triangles =
    in_place(simulation.start_triangles(), vesicles, vesicle::to_mesh(output));
  vesicle::use_double_points(output);
  output->SetPolys(vesicle::to_cells(triangles));
  vesicle::add_fields(in_place(simulation.fields(state), order), scene, output);
  add_geometry(simulation.diagnose_all(state), output->GetFieldData());
  vesicle::add_medium(scene, 0, output->GetFieldData());
  if (vesicles.size() > 1)
  {
    add_vesicles(vesicles, output);
  }
}

}

vtkStandardNewMacro(vtkVesicleForceFilter);

int vtkVesicleForceFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  vesicle::request_whole(inputs[0]);
  vesicle::request_start(inputs[1]);
  return 1;
}

int vtkVesicleForceFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataObject* input = vtkDataObject::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  if (!vesicle::is_first_piece(outputs))
  {
    return 1;
  }
  try
  {
    output->ShallowCopy(vesicle::membrane_of(input));
    if (output->GetNumberOfPolys() == 0)
    {
      vtkWarningMacro(<< "the input has no triangles: there is nothing to solve for");
      return 1;
    }
    std::string field_notes;
    vesicle::Scene scene = vesicle::with_velocity_field(this->MakeScene(), field_notes);
    scene.flow =
      vesicle::flow_with_field(scene.flow, vtkDataObject::GetData(inputs[1]), field_notes);
    if (this->BendingForce == Fitted)
    {
      scene.accuracy.bending = vesicle::Scene::Bending::fit;
    }
    const Vesicles vesicles = vesicle::vesicle_points(output);
    const vesicle::TriangleMesh mesh = vesicle::to_mesh(output);
    const auto reference = vesicle::reference_mesh_of(scene);
    std::vector<vesicle::StartMesh> start;
    for (const auto& points : vesicles)
    {
      vesicle::TriangleMesh own = vesicle::part_with(mesh, points);
      std::string notes = vesicle::prepare_for_dynamics(own, "input");
      start.push_back({ std::move(own), std::move(notes), reference });
    }
    start.front().notes = vesicle::lines({ start.front().notes, field_notes });
    scene.companions.assign(vesicles.size() - 1, scene.companion());
    Simulation simulation(scene, start);
    if (!simulation.notes().empty())
    {
      vtkWarningMacro(<< simulation.notes());
    }
    solve(scene, simulation, vesicles, output);
    return 1;
  }
  catch (const std::exception& error)
  {
    output->Initialize();
    vtkErrorMacro(<< error.what());
    return 0;
  }
}

void vtkVesicleForceFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "BendingForce: " << (this->BendingForce == Fitted ? "fitted" : "dynamics")
     << '\n';
}
