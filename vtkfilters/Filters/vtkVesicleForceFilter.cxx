#include "vtkVesicleForceFilter.h"

#include "MeshConversion.h"
#include "SceneNumbers.h"
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

#include <string>

namespace
{

using vesicle::Simulation;

void solve(const vesicle::Scene& scene, Simulation& simulation, vtkPolyData* output)
{
  const vesicle::State state = simulation.instant();
  vesicle::use_double_points(output);
  output->SetPolys(vesicle::to_cells(simulation.start_mesh().triangles));
  vesicle::add_fields(simulation.fields(state), scene, output);
  const vesicle::Diagnostics numbers = simulation.diagnose(state);
  vtkFieldData* to = output->GetFieldData();
  vesicle::add_number(to, "Area", numbers.area);
  vesicle::add_number(to, "Volume", numbers.volume);
  vesicle::add_number(to, "Reduced_Volume", numbers.reduced_volume);
  vesicle::add_number(to, "Bending_Energy", numbers.bending_energy);
  vesicle::add_medium(scene, 0, to);
}

}

vtkStandardNewMacro(vtkVesicleForceFilter);

int vtkVesicleForceFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
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
    if (this->BendingForce == Fitted)
    {
      scene.accuracy.bending = vesicle::Scene::Bending::fit;
    }
    vesicle::TriangleMesh mesh = vesicle::to_mesh(output);
    const std::string changes = vesicle::prepare_for_dynamics(mesh, "input");
    Simulation simulation(scene, std::move(mesh), vesicle::lines({ changes, field_notes }));
    if (!simulation.notes().empty())
    {
      vtkWarningMacro(<< simulation.notes());
    }
    solve(scene, simulation, output);
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
