#include "SceneNumbers.h"

#include "ArrayLabels.h"
#include "MeshConversion.h"

#include "solver/Errors.h"
#include "solver/flow/FlowKinds.h"
#include "solver/flow/FlowNumbers.h"
#include "solver/mesh/Topology.h"
#include "solver/mesh/repair/Components.h"
#include "solver/scene/SceneNames.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numeric>

namespace vesicle
{
namespace
{

constexpr const char* vesicle_ids_name = "Vesicle_Id";

/// Field data of a flow's parameter: "rate" is Flow_Rate.
std::string array_name(std::string parameter)
{
  parameter[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(parameter[0])));
  return "Flow_" + parameter;
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

/// One a vesicle.
void read_ratios(vtkDataArray* ratios, Scene& scene)
{
  if (ratios->GetNumberOfTuples() == 0 || ratios->GetNumberOfComponents() != 1)
  {
    throw InputError("the surface's field data Viscosity_Ratio must be one number a vesicle");
  }
  scene.companions.resize(ratios->GetNumberOfTuples() - 1);
  for (vtkIdType v = 0; v < ratios->GetNumberOfTuples(); ++v)
  {
    const double ratio = ratios->GetComponent(v, 0);
    if (!(ratio >= 0 && std::isfinite(ratio)))
    {
      throw InputError("the surface's field data Viscosity_Ratio must be 0 or more");
    }
    (v == 0 ? scene.fluid.viscosity_ratio : scene.companions[v - 1].viscosity_ratio) = ratio;
  }
}

void add_vector(vtkFieldData* to, const char* name, const Vector3& vector)
{
  to->AddArray(to_array(name, Eigen::MatrixXd(vector.transpose())));
}

Wall read_wall(vtkFieldData* from)
{
  Wall wall;
  read(from, "Wall_Point", wall.point.data(), 3);
  read(from, "Wall_Normal", wall.normal.data(), 3);
  if (!(wall.normal.norm() > 0))
  {
    throw InputError("the surface's field data Wall_Normal must not be 0");
  }
  wall.normal.normalize();
  return wall;
}

std::shared_ptr<const ImposedFlow> read_flow(vtkFieldData* from)
{
  const double number = read_number(from, "Flow_Kind");
  const auto kinds = static_cast<int>(flow_kinds().size());
  if (!(number >= 0 && number <= kinds && number == std::floor(number)))
    throw InputError(
      fmt::format("the surface's field data Flow_Kind is {}; there are 0 to {}", number, kinds));
  if (number > 0 && is_from_file(*flow_kinds()[static_cast<std::size_t>(number) - 1]))
    throw InputError(
      "the surface was in a velocity field of a file, which its data don't hold; add "
      "that field to what the membrane does in a fluid at rest (Flow_Kind 0)");
  return flow_of(static_cast<int>(number),
    [&](const std::string& parameter, std::span<double> values)
    { read(from, array_name(parameter).c_str(), values.data(), static_cast<int>(values.size())); });
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

void add_numbers(vtkFieldData* to, const char* name, const std::vector<double>& values)
{
  to->AddArray(to_array(name,
    Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()))));
}

void add_vesicle_ids(const std::vector<int>& ids, vtkPolyData* surface)
{
  vtkNew<vtkIntArray> array;
  array->SetName(vesicle_ids_name);
  for (const int id : ids)
  {
    array->InsertNextValue(id);
  }
  label(array);
  surface->GetPointData()->AddArray(array);
}

std::vector<std::vector<int>> vesicle_points(vtkPolyData* surface)
{
  const TriangleMesh mesh = to_mesh(surface);
  vtkDataArray* ids = surface->GetPointData()->GetArray(vesicle_ids_name);
  std::vector<std::vector<int>> vesicles;
  if (!ids)
  {
    const auto components = components_of(mesh);
    if (components.size() < 2 || !topology(mesh).closed) // torn: it is told where it is used
    {
      std::vector<int> all(mesh.points.rows());
      std::iota(all.begin(), all.end(), 0);
      return { all };
    }
    for (const Component& component : components)
    {
      vesicles.push_back(points_of(mesh, component.triangles));
    }
    return vesicles;
  }
  if (ids->GetNumberOfComponents() != 1 || ids->GetNumberOfTuples() != mesh.points.rows())
  {
    throw InputError("the surface's array Vesicle_Id isn't one number a point");
  }
  std::map<double, std::vector<int>> by_id;
  for (int i = 0; i < mesh.points.rows(); ++i)
  {
    const double id = ids->GetComponent(i, 0);
    if (!std::isfinite(id))
    {
      throw InputError(fmt::format("Vesicle_Id of point {} is not finite", i));
    }
    by_id[id].push_back(i);
  }
  for (int t = 0; t < mesh.triangles.rows(); ++t)
  {
    const auto id = [&](int corner) { return ids->GetComponent(mesh.triangles(t, corner), 0); };
    if (id(0) != id(1) || id(0) != id(2))
    {
      throw InputError(
        fmt::format("triangle {} of the surface has points of different Vesicle_Id", t));
    }
  }
  for (auto& [id, points] : by_id)
  {
    vesicles.push_back(std::move(points));
  }
  return vesicles;
}

TriangleMesh part_with(const TriangleMesh& mesh, const std::vector<int>& points)
{
  std::vector<int> place(mesh.points.rows(), -1), triangles;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    place[points[i]] = static_cast<int>(i);
  }
  for (int t = 0; t < mesh.triangles.rows(); ++t)
  {
    if (place[mesh.triangles(t, 0)] >= 0)
    {
      triangles.push_back(t);
    }
  }
  TriangleMesh part{ mesh.points(points, Eigen::all), mesh.triangles(triangles, Eigen::all) };
  for (int& corner : part.triangles.reshaped())
  {
    corner = place[corner];
  }
  return part;
}

void add_surface(SurfaceBasis basis, double reduced_volume, vtkFieldData* to)
{
  add_number(to, "Surface_Basis", static_cast<int>(basis));
  add_number(to, "Reduced_Volume", reduced_volume);
}

SurfaceBasis surface_basis(vtkFieldData* from)
{
  vtkDataArray* number = from->GetArray("Surface_Basis");
  const bool loop = number && number->GetNumberOfValues() == 1 && number->GetComponent(0, 0) == 1;
  return loop ? SurfaceBasis::loop : SurfaceBasis::linear;
}

void add_medium(const Scene& scene, double time, vtkFieldData* to)
{
  add_number(to, "Viscosity", scene.fluid.viscosity);
  std::vector<double> ratios{ scene.fluid.viscosity_ratio };
  for (const Scene::Companion& companion : scene.companions)
    ratios.push_back(companion.viscosity_ratio);
  add_numbers(to, "Viscosity_Ratio", ratios);
  add_number(to, "Surface_Basis", static_cast<int>(scene.accuracy.basis));
  if (scene.wall)
  {
    add_vector(to, "Wall_Point", scene.wall->point);
    add_vector(to, "Wall_Normal", scene.wall->normal);
  }
  const auto flow = flow_at(imposed_flow(scene), time);
  add_number(to, "Flow_Kind", flow ? number_of(flow->kind()) : 0);
  if (!flow)
    return;
  for (const FlowNumbers& numbers : numbers_of(*flow))
    to->AddArray(to_array(array_name(numbers.name).c_str(),
      Eigen::Map<const Eigen::RowVectorXd>(
        numbers.values.data(), static_cast<Eigen::Index>(numbers.values.size()))));
}

Scene read_medium(vtkFieldData* from)
{
  Scene scene;
  scene.fluid.viscosity = read_number(from, "Viscosity");
  if (!(scene.fluid.viscosity > 0))
  {
    throw InputError("the surface's field data Viscosity must be above 0");
  }
  if (vtkDataArray* ratios = from->GetArray("Viscosity_Ratio")) // of files of this version on
  {
    read_ratios(ratios, scene);
  }
  scene.accuracy.basis =
    read_number(from, "Surface_Basis") == 0 ? Scene::Basis::linear : Scene::Basis::loop;
  scene.flow = read_flow(from);
  if (from->HasArray("Wall_Normal"))
  {
    scene.wall = read_wall(from);
  }
  return scene;
}

}
