#include "GridConversion.h"

#include "FileArrays.h"
#include "MeshConversion.h"

#include "solver/Errors.h"
#include "solver/mesh/PolygonMesh.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace vesicle
{
namespace
{

using Kind = GridFile::Kind;

[[noreturn]] void fail(const std::string& name, const std::string& problem)
{
  throw InputError(fmt::format("{}: {}; write it anew", name, problem));
}

void require_finite(std::span<const double> numbers, const char* what, const std::string& name)
{
  for (const double number : numbers)
    if (!(std::abs(number) <= greatest_coordinate))
      fail(name, fmt::format("{} has {}", what, number));
}

std::int64_t points_along(const GridFile& grid, int axis)
{
  return static_cast<std::int64_t>(grid.extent[2 * axis + 1]) - grid.extent[2 * axis] + 1;
}

/// Points in a structured order are as many as the extent says.
void require_points(const GridFile& grid, const std::string& name)
{
  const std::int64_t points = grid.points.rows();
  std::int64_t left = points;
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::int64_t along = points_along(grid, axis);
    if (along < 1 || left % along != 0)
      fail(name, fmt::format("{} points don't fill its extent", points));
    left /= along;
  }
  if (left != 1)
    fail(name, fmt::format("{} points don't fill its extent", points));
}

vtkSmartPointer<vtkDataSet> image_of(const GridFile& grid, const std::string& name)
{
  require_finite(grid.origin, "the origin", name);
  require_finite(grid.spacing, "the spacing", name);
  require_finite(grid.axes, "the direction", name);
  if (std::ranges::any_of(grid.spacing, [](double step) { return step == 0; }))
    fail(name, "a spacing is 0");
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(const_cast<int*>(grid.extent.data()));
  image->SetOrigin(grid.origin.data());
  image->SetSpacing(grid.spacing.data());
  if (grid.axes != GridFile{}.axes)
    image->SetDirectionMatrix(grid.axes.data());
  return image;
}

vtkNew<vtkDoubleArray> array_of(const std::vector<double>& numbers)
{
  vtkNew<vtkDoubleArray> array;
  array->SetNumberOfTuples(static_cast<vtkIdType>(numbers.size()));
  std::copy(numbers.begin(), numbers.end(), array->GetPointer(0));
  return array;
}

vtkSmartPointer<vtkDataSet> rectilinear_of(const GridFile& grid, const std::string& name)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::vector<double>& along = grid.coordinates[axis];
    require_finite(along, "a coordinate", name);
    if (static_cast<std::int64_t>(along.size()) != points_along(grid, axis))
      fail(name,
        fmt::format("has {} coordinates for {} points along axis {}", along.size(),
          points_along(grid, axis), axis));
    if (!std::ranges::is_sorted(along))
      fail(name, fmt::format("coordinates along axis {} don't ascend", axis));
  }
  auto result = vtkSmartPointer<vtkRectilinearGrid>::New();
  result->SetExtent(const_cast<int*>(grid.extent.data()));
  result->SetXCoordinates(array_of(grid.coordinates[0]));
  result->SetYCoordinates(array_of(grid.coordinates[1]));
  result->SetZCoordinates(array_of(grid.coordinates[2]));
  return result;
}

vtkSmartPointer<vtkDataSet> structured_of(const GridFile& grid, const std::string& name)
{
  require_points(grid, name);
  check_points(grid.points, name);
  auto result = vtkSmartPointer<vtkStructuredGrid>::New();
  result->SetExtent(const_cast<int*>(grid.extent.data()));
  result->SetPoints(to_vtk_points(grid.points));
  return result;
}

vtkNew<vtkIdTypeArray> ids_of(const std::vector<std::int64_t>& numbers)
{
  vtkNew<vtkIdTypeArray> array;
  array->SetNumberOfValues(static_cast<vtkIdType>(numbers.size()));
  std::copy(numbers.begin(), numbers.end(), array->GetPointer(0));
  return array;
}

vtkSmartPointer<vtkDataSet> unstructured_of(const GridFile& grid, const std::string& name)
{
  check_points(grid.points, name);
  vtkNew<vtkUnsignedCharArray> types;
  for (const std::int64_t type : grid.types)
    types->InsertNextValue(static_cast<unsigned char>(std::clamp<std::int64_t>(type, 0, 255)));
  vtkNew<vtkCellArray> cells;
  cells->SetData(ids_of(grid.offsets), ids_of(grid.corners));
  auto result = vtkSmartPointer<vtkUnstructuredGrid>::New();
  result->SetPoints(to_vtk_points(grid.points));
  if (grid.first_face.empty())
    result->SetCells(types, cells);
  else
    result->SetCells(types, cells, ids_of(grid.first_face), ids_of(grid.faces));
  return result;
}

void require_tuples(
  const std::vector<DataArray>& arrays, std::int64_t count, const char* of, const std::string& name)
{
  for (const DataArray& array : arrays)
    if (array.tuples() != count)
      fail(name,
        fmt::format(
          "the array '{}' has {} tuples for {} {}", array.name, array.tuples(), count, of));
}

vtkSmartPointer<vtkDataSet> bare(const GridFile& grid, const std::string& name)
{
  switch (grid.kind)
  {
    case Kind::image:
      return image_of(grid, name);
    case Kind::rectilinear:
      return rectilinear_of(grid, name);
    case Kind::structured:
      return structured_of(grid, name);
    default:
      return unstructured_of(grid, name);
  }
}

}

vtkSmartPointer<vtkDataSet> to_data_set(const GridFile& grid, const std::string& name)
{
  auto result = bare(grid, name);
  const auto cells = grid.kind == Kind::unstructured ? static_cast<std::int64_t>(grid.types.size())
                                                     : result->GetNumberOfCells();
  require_tuples(grid.point_data, result->GetNumberOfPoints(), "points", name);
  require_tuples(grid.cell_data, cells, "cells", name);
  add_arrays(grid.point_data, result->GetPointData());
  add_arrays(grid.cell_data, result->GetCellData());
  return result;
}

}
