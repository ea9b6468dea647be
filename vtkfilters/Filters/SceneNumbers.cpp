#include "SceneNumbers.h"

#include "MeshConversion.h"

#include "solver/Errors.h"
#include "solver/scene/SceneNames.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vesicle
{
namespace
{

using Kind = Scene::Flow::Kind;

// Flow_Kind is the index plus 1.
constexpr std::array kinds{ Kind::uniform, Kind::shear, Kind::planar_extension,
  Kind::axisymmetric_extension, Kind::poiseuille };

bool has_rate(Kind kind)
{
  return kind != Kind::uniform && kind != Kind::poiseuille;
}

int number_of(Kind kind)
{
  return 1 + static_cast<int>(std::find(kinds.begin(), kinds.end(), kind) - kinds.begin());
}

void add_vector(vtkFieldData* to, const char* name, const Vector3& value)
{
  to->AddArray(to_array(name, value.transpose()));
}

void read(vtkFieldData* from, const char* name, double* values, int count)
{
  vtkDataArray* array = from->GetArray(name);
  if (!array || array->GetNumberOfTuples() != 1 || array->GetNumberOfComponents() != count)
  {
    throw InputError(
      fmt::format("the surface lacks the field data {} ({} number{}), which frames of a run, "
                  "vtkVesicleStepper and vtkVesicleForceFilter have",
        name, count, count == 1 ? "" : "s"));
  }
  array->GetTuple(0, values);
  if (!std::all_of(values, values + count, [](double x) { return std::isfinite(x); }))
  {
    throw InputError(fmt::format("the surface's field data {} is not finite", name));
  }
}

double read_number(vtkFieldData* from, const char* name)
{
  double value = 0;
  read(from, name, &value, 1);
  return value;
}

std::optional<Scene::Flow> read_flow(vtkFieldData* from)
{
  const double number = read_number(from, "Flow_Kind");
  if (number == 0)
  {
    return {};
  }
  const int kind = static_cast<int>(number);
  if (kind != number || kind < 0 || kind > static_cast<int>(kinds.size()))
  {
    throw InputError(fmt::format(
      "the surface's field data Flow_Kind is {}; there are 0 to {}", number, kinds.size()));
  }
  double rate = 0, radius = 1, velocity[3] = {}, center[3] = {};
  if (has_rate(kinds[kind - 1]))
  {
    rate = read_number(from, "Flow_Rate");
  }
  else
  {
    read(from, "Flow_Velocity", velocity, 3);
  }
  if (kinds[kind - 1] == Kind::poiseuille)
  {
    radius = read_number(from, "Flow_Radius");
    read(from, "Flow_Center", center, 3);
  }
  return make_flow(kind, rate, velocity, radius, center);
}

}

void add_fields(
  const std::map<std::string, Eigen::MatrixXd>& fields, const Scene& scene, vtkPolyData* surface)
{
  vtkPointData* arrays = surface->GetPointData();
  for (const auto& name : field_names)
  {
    arrays->RemoveArray(name.c_str());
  }
  const auto& chosen = scene.output.fields;
  for (const auto& [name, values] : fields)
  {
    if (chosen.empty() || std::find(chosen.begin(), chosen.end(), name) != chosen.end())
    {
      arrays->AddArray(to_array(name, values));
    }
  }
  arrays->SetActiveScalars("Mean_Curvature");
  arrays->SetActiveNormals("Normals");
  arrays->SetActiveVectors("Velocity");
}

void add_number(vtkFieldData* to, const char* name, double value)
{
  to->AddArray(to_array(name, Eigen::MatrixXd::Constant(1, 1, value)));
}

void add_medium(const Scene& scene, vtkFieldData* to)
{
  add_number(to, "Viscosity", scene.fluid.viscosity);
  add_number(to, "Surface_Basis", scene.accuracy.basis == Scene::Basis::loop);
  add_number(to, "Flow_Kind", scene.flow ? number_of(scene.flow->kind) : 0);
  if (!scene.flow)
  {
    return;
  }
  const Scene::Flow& flow = *scene.flow;
  if (has_rate(flow.kind))
  {
    add_number(to, "Flow_Rate", flow.rate);
  }
  else if (flow.kind == Kind::uniform)
  {
    add_vector(to, "Flow_Velocity", flow.velocity);
  }
  else
  {
    add_vector(to, "Flow_Velocity", flow.speed * flow.axis);
    add_number(to, "Flow_Radius", flow.radius);
    add_vector(to, "Flow_Center", flow.center);
  }
}

Scene read_medium(vtkFieldData* from)
{
  Scene scene;
  scene.fluid.viscosity = read_number(from, "Viscosity");
  if (!(scene.fluid.viscosity > 0))
  {
    throw InputError("the surface's field data Viscosity must be above 0");
  }
  scene.accuracy.basis =
    read_number(from, "Surface_Basis") == 0 ? Scene::Basis::linear : Scene::Basis::loop;
  scene.flow = read_flow(from);
  return scene;
}

std::optional<Scene::Flow> make_flow(
  int kind, double rate, const double velocity[3], double radius, const double center[3])
{
  if (kind == 0)
  {
    return {};
  }
  Scene::Flow flow;
  flow.kind = kinds.at(kind - 1);
  flow.rate = rate;
  flow.velocity = Eigen::Map<const Vector3>(velocity);
  flow.speed = flow.velocity.norm();
  if (flow.speed > 0)
  {
    flow.axis = flow.velocity / flow.speed;
  }
  flow.radius = radius;
  flow.center = Eigen::Map<const Vector3>(center);
  return flow;
}

}
