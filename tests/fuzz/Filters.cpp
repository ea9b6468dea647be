// A surface as a pipeline may hand it over, and a filter that takes it: an error and an empty
// output, or an output that can be worked with, whose computed arrays are finite.
//
// The first byte chooses the filter, the second its settings; from the rest the surface is made,
// step by step.
#include "tests/fuzz/Bytes.h"
#include "tests/fuzz/Fault.h"
#include "tests/fuzz/Surfaces.h"
#include "tests/fuzz/Targets.h"

#include "solver/Errors.h"
#include "solver/mesh/shapes/GeodesicSphere.h"
#include "tests/support/TemporaryFolder.h"
#include "vtkfilters/Filters/MeshConversion.h"
#include "vtkfilters/Filters/MeshFiles.h"
#include "vtkfilters/Filters/VtkMessages.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkVesicleCurvatureFilter.h"
#include "vtkVesicleForceFilter.h"
#include "vtkVesicleMeshWriter.h"
#include "vtkVesicleProbeFilter.h"
#include "vtkVesicleStepper.h"

#include <array>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

namespace vesicle::fuzz
{
namespace
{

constexpr const char* array_names[] = { "Membrane_Force", "Gravity_Force", "Tension",
  "Tension_Force", "vtkGhostType", "Normals", "Mean_Curvature", "Viscosity", "Surface_Basis",
  "Flow_Kind", "Flow_Rate", "Flow_Velocity", "Flow_Radius", "Flow_Center", "Flow_Axis", "RGB", "x",
  "", "Vesicle_Id" };

constexpr const char* computed_names[] = { "Gauss_Curvature", "Laplacian_Mean_Curvature",
  "Bending_Force", "Mean_Curvature", "Normals", "Velocity", "Fit_Residual", "Maximum_Curvature",
  "Minimum_Curvature", "Maximum_Direction", "Minimum_Direction", "Curvedness", "Shape_Index",
  "Willmore_Density", "Mean_Curvature_Error" };

/// Mostly an ordinary number, sometimes one that programs trip over.
double any_number(Bytes& bytes)
{
  const auto byte = bytes.take<std::uint8_t>();
  return byte < 160 ? (byte - 80) / 40.0 : special_number(byte - 160);
}

vtkIdType any_index(Bytes& bytes)
{
  constexpr vtkIdType far[] = { -1, -7, 900000000, 2147483647, 2147483648, -2147483649, 4294967296,
    1LL << 62, -(1LL << 62) };
  const auto byte = bytes.take<std::uint8_t>();
  return byte < 240 ? byte : far[byte % std::size(far)];
}

/// Makes a surface of the bytes. Where a step can't be done it isn't.
class SurfaceMaker
{
public:
  explicit SurfaceMaker(Bytes bytes) : bytes_(bytes)
  {
    surface_->SetPoints(vtkNew<vtkPoints>());
    surface_->SetPolys(vtkNew<vtkCellArray>()); // without, VTK hands out one that all share
    start();
    constexpr int most_steps = 64;
    for (int i = 0; i < most_steps && !bytes_.empty(); ++i)
      step();
  }

  vtkPolyData* surface() { return surface_; }

private:
  void start()
  {
    const int shape = bytes_.below(6);
    if (shape > 0)
      surface_ = to_polydata(geodesic_sphere(1 + shape / 4));
    if (shape % 2 == 1)
    {
      vtkNew<vtkPoints> single;
      single->DeepCopy(surface_->GetPoints());
      surface_->SetPoints(single);
    }
  }

  void step()
  {
    switch (bytes_.below(13))
    {
      case 0:
        return set_point();
      case 1:
        return set_value(corners(), any_index(bytes_), any_index(bytes_));
      case 2:
        return set_value(offsets(), any_index(bytes_), any_index(bytes_));
      case 3:
        return add_cell(&vtkPolyData::GetPolys, &vtkPolyData::SetPolys);
      case 4:
        return add_cell(&vtkPolyData::GetStrips, &vtkPolyData::SetStrips);
      case 5:
        return add_cell(&vtkPolyData::GetLines, &vtkPolyData::SetLines);
      case 6:
        return add_cell(&vtkPolyData::GetVerts, &vtkPolyData::SetVerts);
      case 7:
        return add_point();
      case 8:
        return add_array();
      case 9:
        surface_->GetPolys()->ConvertTo32BitStorage();
        return;
      case 10:
        return scale();
      case 11:
        return resize(corners());
      default:
        return resize(offsets());
    }
  }

  vtkDataArray* corners() { return surface_->GetPolys()->GetConnectivityArray(); }
  vtkDataArray* offsets() { return surface_->GetPolys()->GetOffsetsArray(); }
  vtkIdType any_size(vtkIdType around)
  {
    return std::max<vtkIdType>(0, around + bytes_.below(9) - 6);
  }

  void resize(vtkDataArray* array) { array->Resize(any_size(array->GetNumberOfTuples())); }

  static void set_value(vtkDataArray* array, vtkIdType place, vtkIdType value)
  {
    if (array->GetNumberOfTuples() > 0)
      array->SetComponent(
        std::abs(place % array->GetNumberOfTuples()), 0, static_cast<double>(value));
  }

  void set_point()
  {
    const vtkIdType count = surface_->GetNumberOfPoints();
    const int point = bytes_.below(256), axis = bytes_.below(3);
    const double value = any_number(bytes_);
    if (count > 0)
      surface_->GetPoints()->GetData()->SetComponent(point % count, axis, value);
  }

  void add_point()
  {
    const std::array<double, 3> x{ any_number(bytes_), any_number(bytes_), any_number(bytes_) };
    surface_->GetPoints()->InsertNextPoint(x.data());
  }

  void scale()
  {
    const double factor = any_number(bytes_), shift = any_number(bytes_);
    vtkDataArray* points = surface_->GetPoints()->GetData();
    for (vtkIdType i = 0; i < points->GetNumberOfTuples(); ++i)
      for (int axis = 0; axis < 3; ++axis)
        points->SetComponent(i, axis, points->GetComponent(i, axis) * factor + shift);
  }

  void add_cell(vtkCellArray* (vtkPolyData::*get)(), void (vtkPolyData::*set)(vtkCellArray*))
  {
    vtkNew<vtkCellArray> cells;
    cells->DeepCopy((surface_.Get()->*get)());
    std::vector<vtkIdType> corners(bytes_.below(7));
    for (vtkIdType& corner : corners)
      corner = any_index(bytes_);
    cells->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
    (surface_.Get()->*set)(cells);
  }

  void add_array()
  {
    constexpr int types[] = { VTK_DOUBLE, VTK_FLOAT, VTK_UNSIGNED_CHAR, VTK_INT, VTK_ID_TYPE,
      VTK_BIT, VTK_STRING, VTK_CHAR };
    const int place = bytes_.below(3), type = types[bytes_.below(std::size(types))];
    const char* name = array_names[bytes_.below(std::size(array_names))];
    auto array = vtk::TakeSmartPointer(vtkAbstractArray::CreateArray(type));
    array->SetName(*name ? name : nullptr);
    array->SetNumberOfComponents(1 + bytes_.below(4));
    const vtkIdType counts[] = { surface_->GetNumberOfPoints(), surface_->GetNumberOfCells(), 1 };
    const bool another = bytes_.below(4) == 0;
    array->SetNumberOfTuples(another ? any_size(counts[place]) : counts[place]);
    if (auto* numbers = vtkDataArray::SafeDownCast(array))
      fill(numbers);
    vtkFieldData* data[] = { surface_->GetPointData(), surface_->GetCellData(),
      surface_->GetFieldData() };
    data[place]->AddArray(array);
  }

  /// Wholly, as VTK leaves memory as it finds it.
  void fill(vtkDataArray* array)
  {
    const bool floating = array->GetDataType() == VTK_DOUBLE || array->GetDataType() == VTK_FLOAT;
    const double first = any_number(bytes_), second = any_number(bytes_);
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        const double value = (i + c) % 2 ? first : second;
        array->SetComponent(i, c, floating ? value : std::fmod(i, 4));
      }
  }

  Bytes bytes_;
  vtkSmartPointer<vtkPolyData> surface_ = vtkSmartPointer<vtkPolyData>::New();
};

void require_finite(vtkPointData* arrays)
{
  for (const char* name : computed_names)
    if (vtkDataArray* array = arrays->GetArray(name))
      for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
        for (int c = 0; c < array->GetNumberOfComponents(); ++c)
          require(std::isfinite(array->GetComponent(i, c)), std::string(name) + " isn't finite");
}

void update(vtkAlgorithm* filter)
{
  const VtkMessages messages;
  filter->Update();
  auto* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  if (!output)
    return;
  if (messages.any_error())
    require(output->GetNumberOfPoints() == 0, "after an error there is an output");
  else if (output->GetNumberOfPolys() > 0)
  {
    require_sound(output);
    require_finite(output->GetPointData());
  }
}

void curvature(vtkPolyData* surface, Bytes settings)
{
  vtkNew<vtkVesicleCurvatureFilter> filter;
  filter->SetInputData(surface);
  filter->SetScheme(settings.below(3));
  filter->SetCurvatureType(settings.below(4));
  filter->SetOrientOutward(settings.below(4) > 0);
  filter->SetFitRadius(any_number(settings));
  filter->SetPrincipalCurvatures(settings.below(2) > 0);
  filter->SetShapeDescriptors(settings.below(2) > 0);
  update(filter);
}

void set_scene(vtkVesicleSceneAlgorithm* filter, Bytes& settings)
{
  constexpr int presets[] = { 0, 1, 0, 1, 0, 1, 2, 3 }; // flat triangles take less time
  filter->SetPreset(presets[settings.below(std::size(presets))]);
  filter->SetFlowKind(settings.below(7));
  filter->SetIncompressible(settings.below(2) > 0);
  filter->SetBendingRigidity(any_number(settings));
  filter->SetSpontaneousCurvature(any_number(settings));
  filter->SetViscosity(any_number(settings));
  filter->SetFlowRate(any_number(settings));
  filter->SetBondNumber(any_number(settings));
}

void force(vtkPolyData* surface, Bytes settings)
{
  vtkNew<vtkVesicleForceFilter> filter;
  filter->SetInputData(surface);
  filter->SetBendingForce(settings.below(2));
  set_scene(filter, settings);
  update(filter);
}

void step(vtkPolyData* surface, Bytes settings)
{
  vtkNew<vtkVesicleStepper> stepper;
  stepper->SetInputData(surface);
  set_scene(stepper, settings);
  stepper->SetPreset(
    stepper->GetPreset() % 2); // of flat triangles: with sanitizers others take 10 s
  const double step = std::ldexp(1, -settings.below(30));
  stepper->SetTimeStep(step);
  const VtkMessages messages;
  stepper->UpdateTimeStep(step);
  require_finite(stepper->GetOutput()->GetPointData());
}

/// Where the force filter got through, its output as well.
void probe(vtkPolyData* surface, Bytes settings)
{
  vtkNew<vtkPolyData> where;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(1, 0.25, -0.5);
  points->InsertNextPoint(1e5, 0, 0);
  where->SetPoints(points);
  vtkNew<vtkVesicleForceFilter> forces;
  forces->SetInputData(surface);
  set_scene(forces, settings);
  vtkNew<vtkVesicleProbeFilter> probe;
  probe->SetInputData(where);
  for (vtkPolyData* source : { surface, forces->GetOutput() })
  {
    const VtkMessages messages;
    if (source != surface)
      forces->Update();
    probe->SetSourceData(source);
    probe->Update();
    require_finite(probe->GetOutput()->GetPointData());
  }
}

void write(vtkPolyData* surface, Bytes settings)
{
  static const test::TemporaryFolder folder;
  constexpr const char* names[] = { "mesh.vtu", "mesh.vtp", "mesh.vtk", "mesh.stl", "mesh.ply",
    "mesh.obj", "mesh.off" };
  const auto file = folder / names[settings.below(std::size(names))];
  std::filesystem::remove(file);
  const VtkMessages messages;
  vtkNew<vtkVesicleMeshWriter> writer;
  writer->SetInputData(surface);
  writer->SetFileName(file.c_str());
  writer->Write();
  require(messages.any_error() != std::filesystem::exists(file), "the writer says otherwise");
  if (messages.any_error())
    return;
  const auto triangles = triangulated(surface);
  if (triangles->GetNumberOfPolys() > 0)
  {
    const auto again = read_mesh(file);
    require_sound(again);
    require(again->GetNumberOfPolys() == triangles->GetNumberOfPolys(),
      "other triangles are read than were written");
  }
}

void convert(vtkPolyData* surface, Bytes settings)
{
  try
  {
    const auto membrane = membrane_of(surface);
    require_sound(membrane);
    require_sound(merged(membrane, std::ldexp(1, settings.below(64) - 60)));
    to_frame(membrane, 0);
  }
  catch (const InputError& error)
  {
    require(std::string_view(error.what()).starts_with("input: "), error.what());
  }
}

}

void filters(std::string_view bytes)
{
  constexpr decltype(&curvature) all[] = { curvature, force, probe, write, convert, step };
  Bytes input(bytes);
  const int filter = input.below(std::size(all));
  constexpr std::size_t settings_size = 12;
  const std::string_view rest = input.rest();
  SurfaceMaker made(Bytes(rest.substr(std::min(settings_size, rest.size()))));
  all[filter](made.surface(), Bytes(rest.substr(0, settings_size)));
}

}
