#include "GridConversion.h"

#include "FileArrays.h"
#include "MeshConversion.h"

#include "solver/Errors.h"

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
#include <array>

namespace vesicle
{
namespace
{

using Kind = GridFile::Kind;

template<class Grid>
vtkSmartPointer<Grid> of_extent(const std::array<int, 6>& e)
{
  auto grid = vtkSmartPointer<Grid>::New();
  grid->SetExtent(e[0], e[1], e[2], e[3], e[4], e[5]);
  return grid;
}

vtkSmartPointer<vtkDataSet> image_of(const GridFile& grid)
{
  auto image = of_extent<vtkImageData>(grid.extent);
  image->SetOrigin(grid.origin.data());
  image->SetSpacing(grid.spacing.data());
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

vtkSmartPointer<vtkDataSet> rectilinear_of(const GridFile& grid)
{
  auto result = of_extent<vtkRectilinearGrid>(grid.extent);
  result->SetXCoordinates(array_of(grid.coordinates[0]));
  result->SetYCoordinates(array_of(grid.coordinates[1]));
  result->SetZCoordinates(array_of(grid.coordinates[2]));
  return result;
}

vtkSmartPointer<vtkDataSet> structured_of(const GridFile& grid)
{
  auto result = of_extent<vtkStructuredGrid>(grid.extent);
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

vtkSmartPointer<vtkDataSet> unstructured_of(const GridFile& grid)
{
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
      throw InputError(fmt::format("{}: the array '{}' has {} tuples for {} {}; write it anew",
        name, array.name, array.tuples(), count, of));
}

vtkSmartPointer<vtkDataSet> bare(const GridFile& grid)
{
  switch (grid.kind)
  {
    case Kind::image:
      return image_of(grid);
    case Kind::rectilinear:
      return rectilinear_of(grid);
    case Kind::structured:
      return structured_of(grid);
    default:
      return unstructured_of(grid);
  }
}

}

vtkSmartPointer<vtkDataSet> to_data_set(const GridFile& grid, const std::string& name)
{
  const bool unstructured = grid.kind == Kind::unstructured;
  require_tuples(grid.point_data, unstructured ? grid.points.rows() : points_in(grid.extent, name),
    "points", name);
  require_tuples(grid.cell_data,
    unstructured ? static_cast<std::int64_t>(grid.types.size()) : cells_in(grid.extent, name),
    "cells", name);
  auto result = bare(grid);
  add_arrays(grid.point_data, result->GetPointData());
  add_arrays(grid.cell_data, result->GetCellData());
  return result;
}

}
