// The ways in of MeshConversion.h: surfaces of files and pipelines, checked and as triangles.

#include "CellList.h"
#include "FileArrays.h"
#include "MeshConversion.h"

#include "solver/Errors.h"
#include "solver/mesh/MergedPoints.h"
#include "solver/mesh/PolygonMesh.h"
#include "solver/mesh/Triangulation.h"
#include "solver/mesh/io/CellTypes.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTypeInt64Array.h"
#include "vtkTypeTraits.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <type_traits>

namespace vesicle
{
namespace
{

Points points_of(vtkPointSet* surface)
{
  Points points(surface->GetPoints() ? surface->GetNumberOfPoints() : 0, 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    surface->GetPoints()->GetPoint(i, points.row(i).data());
  return points;
}

void check_arrays(
  vtkFieldData* arrays, std::int64_t count, const std::string& what, const std::string& name)
{
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = arrays->GetAbstractArray(i);
    if (array->GetNumberOfTuples() < count)
      throw InputError(fmt::format("{}: the array {} has {} values for {} {}", name,
        array->GetName() ? array->GetName() : "(without a name)", array->GetNumberOfTuples(), count,
        what));
  }
}

struct Cells
{
  PolygonList polygons;
  std::int64_t count = 0; ///< with those that aren't polygons
};

Cells cells_of(vtkPolyData* surface, const std::string& name)
{
  const CellList verts(surface->GetVerts(), "vertices", name);
  const CellList lines(surface->GetLines(), "lines", name);
  const CellList polygons(surface->GetPolys(), "polygons", name);
  const CellList strips(surface->GetStrips(), "triangle strips", name);
  Cells cells;
  cells.count = verts.size() + lines.size();
  for (std::int64_t i = 0; i < polygons.size(); ++i)
    cells.polygons.add(polygons[i], cells.count + i);
  cells.count += polygons.size();
  for (std::int64_t i = 0; i < strips.size(); ++i)
    cells.polygons.add_strip(strips[i], cells.count + i);
  cells.count += strips.size();
  return cells;
}

Cells cells_of(vtkUnstructuredGrid* grid, const std::string& name)
{
  Cells cells;
  vtkUnsignedCharArray* types = grid->GetCellTypesArray();
  if (!grid->GetCells() || !types)
    return cells;
  const CellList list(grid->GetCells(), "cells", name);
  if (types->GetNumberOfValues() != list.size())
    throw InputError(fmt::format(
      "{}: there are {} types of {} cells", name, types->GetNumberOfValues(), list.size()));
  cells.count = list.size();
  for (std::int64_t i = 0; i < list.size(); ++i)
    add_cell(cells.polygons, types->GetValue(i), list[i], i, name);
  return cells;
}

/// Each cell's values go to all of its triangles.
void copy_cell_data(vtkCellData* from, const std::vector<std::int64_t>& cells, vtkCellData* to)
{
  const auto count = static_cast<vtkIdType>(cells.size());
  vtkNew<vtkIdList> source, target;
  source->SetNumberOfIds(count);
  target->SetNumberOfIds(count);
  std::copy(cells.begin(), cells.end(), source->GetPointer(0));
  std::iota(target->GetPointer(0), target->GetPointer(0) + count, vtkIdType(0));
  to->CopyAllOn();
  to->CopyAllocate(from, count);
  to->CopyData(from, source, target);
}

/// The same points and arrays with triangles for cells.
vtkSmartPointer<vtkPolyData> with_triangles(vtkPoints* points, vtkPointData* point_data,
  vtkCellData* cell_data, vtkFieldData* field_data, const Triangulation& triangulation)
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(to_cells(triangulation.triangles));
  surface->GetPointData()->ShallowCopy(point_data);
  surface->GetFieldData()->ShallowCopy(field_data);
  copy_cell_data(cell_data, triangulation.cell, surface->GetCellData());
  return surface;
}

/// Whether triangulating changes nothing.
bool has_only(vtkPolyData* surface, const Triangulation& triangulation)
{
  const auto triangles = triangulation.triangles.rows();
  return surface->GetNumberOfPolys() == triangles && surface->GetPolys()->IsHomogeneous() == 3 &&
    surface->GetNumberOfCells() == triangles;
}

/// The first `count` values of each array: what follows belongs to nothing, and no file can hold it.
template<typename Data>
vtkSmartPointer<Data> without_surplus(Data* arrays, std::int64_t count)
{
  bool surplus = false;
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    surplus = surplus || arrays->GetAbstractArray(i)->GetNumberOfTuples() > count;
  if (!surplus)
    return arrays;
  auto cut = vtkSmartPointer<Data>::New();
  cut->CopyAllOn();
  cut->CopyAllocate(arrays, count);
  cut->CopyData(arrays, 0, count, 0);
  return cut;
}

template<typename Data>
vtkSmartPointer<vtkPolyData> as_triangles(Data* surface, const std::string& name)
{
  const Points points = points_of(surface);
  const Cells cells = cells_of(surface, name);
  check_points(points, name);
  check_corners(cells.polygons, points.rows(), name);
  check_arrays(surface->GetPointData(), points.rows(), "points", name);
  check_arrays(surface->GetCellData(), cells.count, "cells", name);
  const auto point_data = without_surplus(surface->GetPointData(), points.rows());
  const auto cell_data = without_surplus(surface->GetCellData(), cells.count);
  const Triangulation triangulation = triangulate(points, cells.polygons, name);
  if constexpr (std::is_same_v<Data, vtkPolyData>)
  {
    if (has_only(surface, triangulation))
    {
      auto same = vtkSmartPointer<vtkPolyData>::New();
      same->ShallowCopy(surface);
      same->GetPointData()->ShallowCopy(point_data);
      same->GetCellData()->ShallowCopy(cell_data);
      return same;
    }
  }
  return with_triangles(
    surface->GetPoints(), point_data, cell_data, surface->GetFieldData(), triangulation);
}

vtkSmartPointer<vtkPoints> points_of(const SurfaceFile& file)
{
  auto points = to_vtk_points(file.points);
  if (file.single_precision)
  {
    auto single = vtkSmartPointer<vtkPoints>::New();
    single->SetDataTypeToFloat();
    single->DeepCopy(points);
    return single;
  }
  return points;
}

/// VTK's numbers by their size: it has several types of the same.
template<typename T>
DataArray::Values values_of(vtkDataArray* array)
{
  const auto n = array->GetNumberOfValues();
  const auto* first = static_cast<const T*>(array->GetVoidPointer(0));
  const auto copied = [&](auto x)
  { return DataArray::Values(std::vector<decltype(x)>(first, first + n)); };
  if constexpr (std::is_floating_point_v<T>)
    return copied(T());
  else if constexpr (std::is_signed_v<T>)
  {
    if constexpr (sizeof(T) == 1)
      return copied(std::int8_t());
    else if constexpr (sizeof(T) == 2)
      return copied(std::int16_t());
    else if constexpr (sizeof(T) == 4)
      return copied(std::int32_t());
    else
      return copied(std::int64_t());
  }
  else if constexpr (sizeof(T) == 1)
    return copied(std::uint8_t());
  else if constexpr (sizeof(T) == 2)
    return copied(std::uint16_t());
  else if constexpr (sizeof(T) == 4)
    return copied(std::uint32_t());
  else
    return copied(std::uint64_t());
}

DataArray::Values values_of(vtkAbstractArray* array)
{
  if (auto* text = vtkStringArray::SafeDownCast(array))
  {
    std::vector<std::string> strings;
    for (vtkIdType i = 0; i < text->GetNumberOfValues(); ++i)
      strings.push_back(text->GetValue(i));
    return strings;
  }
  auto* numbers = vtkDataArray::SafeDownCast(array);
  if (!numbers)
    return std::vector<std::string>();
  if (numbers->GetDataType() == VTK_BIT)
  {
    std::vector<std::uint8_t> bits;
    for (vtkIdType i = 0; i < numbers->GetNumberOfTuples(); ++i)
      for (int k = 0; k < numbers->GetNumberOfComponents(); ++k)
        bits.push_back(numbers->GetComponent(i, k) != 0);
    return bits;
  }
  switch (numbers->GetDataType())
  {
    vtkTemplateMacro(return values_of<VTK_TT>(numbers));
    default:
      return std::vector<std::string>();
  }
}

std::vector<DataArray> to_data_arrays(vtkFieldData* arrays)
{
  std::vector<DataArray> result;
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = arrays->GetAbstractArray(i);
    DataArray copy;
    copy.name = array->GetName() ? array->GetName() : "";
    copy.components = array->GetNumberOfComponents();
    copy.values = values_of(array);
    result.push_back(std::move(copy));
  }
  return result;
}

/// Of a ghost array, whatever its type; 0 where there is none.
bool is_marked(vtkDataArray* ghosts, vtkIdType i, int mask)
{
  if (!ghosts || i >= ghosts->GetNumberOfTuples())
    return false;
  const double value = ghosts->GetComponent(i, 0);
  return value > 0 && value < 256 && (static_cast<int>(value) & mask) != 0;
}

}

vtkSmartPointer<vtkPolyData> triangulated(vtkPolyData* surface, const std::string& name)
{
  return as_triangles(surface, name);
}

vtkSmartPointer<vtkPolyData> triangulated(vtkDataObject* surface, const std::string& name)
{
  if (auto* polydata = vtkPolyData::SafeDownCast(surface))
    return as_triangles(polydata, name);
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(surface))
    return as_triangles(grid, name);
  if (auto* blocks = vtkCompositeDataSet::SafeDownCast(surface))
    return joined(blocks, name);
  throw InputError(name + ": holds no surface; a mesh of triangles is needed");
}

vtkSmartPointer<vtkPolyData> triangulated(const SurfaceFile& file, const std::string& name)
{
  check_points(file.points, name);
  check_corners(file.polygons, file.points.rows(), name);
  vtkNew<vtkPointData> point_data;
  vtkNew<vtkCellData> cell_data;
  vtkNew<vtkFieldData> field_data;
  add_arrays(file.point_data, point_data);
  add_arrays(file.cell_data, cell_data);
  for (const DataArray& array : file.field_data)
    field_data->AddArray(to_vtk(array));
  return with_triangles(points_of(file), point_data, cell_data, field_data,
    triangulate(file.points, file.polygons, name));
}

SurfaceFile to_surface_file(vtkPolyData* triangles)
{
  SurfaceFile file;
  const TriangleMesh mesh = to_mesh(triangles);
  file.points = mesh.points;
  file.single_precision =
    triangles->GetPoints() && triangles->GetPoints()->GetDataType() != VTK_DOUBLE;
  for (const auto& row : mesh.triangles.rowwise())
    file.polygons.add(std::array<std::int64_t, 3>{ row[0], row[1], row[2] }, file.polygons.size());
  file.point_data = to_data_arrays(triangles->GetPointData());
  file.cell_data = to_data_arrays(triangles->GetCellData());
  file.field_data = to_data_arrays(triangles->GetFieldData());
  for (DataArray& array : file.point_data)
    if (vtkDataArray* normals = triangles->GetPointData()->GetNormals();
        normals && normals->GetName() && array.name == normals->GetName())
      array.role = DataArray::Role::normals;
  return file;
}

vtkSmartPointer<vtkPolyData> without_ghosts(vtkPolyData* triangles)
{
  const char* ghosts = vtkDataSetAttributes::GhostArrayName();
  vtkDataArray* points = triangles->GetPointData()->GetArray(ghosts);
  vtkDataArray* cells = triangles->GetCellData()->GetArray(ghosts);
  if (!points && !cells)
    return triangles;
  const TriangleMesh mesh = to_mesh(triangles);
  std::vector<std::array<int, 3>> kept;
  Triangulation left;
  for (int t = 0; t < mesh.triangles.rows(); ++t)
  {
    const auto row = mesh.triangles.row(t);
    const bool is_ghost =
      is_marked(cells, t, vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL) ||
      std::any_of(row.begin(), row.end(),
        [&](int i) { return is_marked(points, i, vtkDataSetAttributes::HIDDENPOINT); });
    if (is_ghost)
      continue;
    kept.push_back({ row[0], row[1], row[2] });
    left.cell.push_back(t);
  }
  left.triangles = Eigen::Map<const Triangles>(
    kept.empty() ? nullptr : kept[0].data(), static_cast<Eigen::Index>(kept.size()), 3);
  return with_triangles(triangles->GetPoints(), triangles->GetPointData(), triangles->GetCellData(),
    triangles->GetFieldData(), left);
}

vtkSmartPointer<vtkPolyData> merged(vtkPolyData* triangles, double distance)
{
  const TriangleMesh mesh = to_mesh(triangles);
  const MergedPoints merging = merged_points(mesh.points, distance);
  const Points points = kept_points(mesh.points, merging);
  vtkNew<vtkIdList> kept, numbers;
  for (const int point : merging.kept)
  {
    numbers->InsertNextId(kept->GetNumberOfIds());
    kept->InsertNextId(point);
  }
  PolygonList polygons;
  for (int t = 0; t < mesh.triangles.rows(); ++t)
  {
    std::array<std::int64_t, 3> triangle;
    for (int k = 0; k < 3; ++k)
      triangle[k] = merging.number[mesh.triangles(t, k)];
    polygons.add(triangle, t);
  }
  vtkNew<vtkPointData> point_data;
  point_data->CopyAllOn();
  point_data->CopyAllocate(triangles->GetPointData(), points.rows());
  point_data->CopyData(triangles->GetPointData(), kept, numbers);
  return with_triangles(to_vtk_points(points), point_data, triangles->GetCellData(),
    triangles->GetFieldData(), triangulate(points, polygons, "mesh"));
}

}
