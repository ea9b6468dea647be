#include "GridCheck.h"

#include "CellList.h"

#include "solver/Errors.h"

#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkGenericCell.h"
#include "vtkImageData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkSmartPointer.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>
#include <span>

namespace vesicle
{
namespace
{

[[noreturn]] void fail(
  const std::string& name, const std::string& problem, const std::string& remedy)
{
  throw InputError(fmt::format("{}: {}; {}", name, problem, remedy));
}

/// Of forms with any number of points.
std::size_t fewest_points(int type)
{
  switch (type)
  {
    case VTK_POLY_LINE:
      return 2;
    case VTK_POLYGON:
    case VTK_TRIANGLE_STRIP:
      return 3;
    case VTK_POLYHEDRON:
      return 4;
    case VTK_QUADRATIC_POLYGON:
      return 6;
    default:
      return 1;
  }
}

/// VTK's forms by their numbers, which go up to 255. Not taken are those of any order, which have as many
/// points as that takes, and only VTK's own cells know how many; and convex sets of points, whose
/// derivatives VTK takes without a look at whether it could triangulate them.
class Forms
{
public:
  /// Points of each; 0: any.
  std::optional<std::size_t> points(int type)
  {
    if (!asked_[type])
    {
      asked_[type] = true;
      const auto form =
        type == VTK_EMPTY_CELL || type == VTK_CONVEX_POINT_SET || type >= VTK_HIGHER_ORDER_EDGE
        ? nullptr
        : vtk::TakeSmartPointer(vtkGenericCell::InstantiateCell(type));
      if (form)
        points_[type] = static_cast<std::size_t>(form->GetNumberOfPoints());
    }
    return points_[type];
  }

private:
  std::array<bool, 256> asked_{};
  std::array<std::optional<std::size_t>, 256> points_;
};

/// Numbers of a polyhedron's faces, from `first` on.
void check_faces(std::span<const std::int64_t> faces, std::int64_t first, std::int64_t points,
  std::int64_t cell, const std::string& name)
{
  const auto wrong = [&]
  { fail(name, fmt::format("the faces of cell {} are damaged", cell), "write it anew"); };
  const auto size = static_cast<std::int64_t>(faces.size());
  std::int64_t at = first;
  const auto next = [&]
  {
    if (at < 0 || at >= size)
      wrong();
    return faces[at++];
  };
  const std::int64_t count = next();
  if (count < 4 || count > size)
    wrong();
  for (std::int64_t face = 0; face < count; ++face)
  {
    const std::int64_t corners = next();
    if (corners < 3 || corners > size - at)
      wrong();
    for (std::int64_t k = 0; k < corners; ++k)
      if (const std::int64_t point = next(); point < 0 || point >= points)
        fail(name, fmt::format("a face of cell {} has a point {} that there isn't", cell, point),
          "mend it");
  }
}

/// Nothing follows a cell's number before it is known to be one of a point.
void check_cells(vtkUnstructuredGrid* grid, const std::string& name)
{
  if (!grid->GetCells())
    return;
  const CellList cells(grid->GetCells(), "cells", name);
  vtkUnsignedCharArray* types = grid->GetCellTypesArray();
  if (!types || types->GetNumberOfValues() != cells.size())
    fail(name, "hasn't a type for each of its cells", "write it anew");
  const auto numbers = [](vtkDataArray* array)
  { return array ? CellList::numbers(array) : std::vector<std::int64_t>(); };
  const std::vector<std::int64_t> faces = numbers(grid->GetFaces()),
                                  first_face = numbers(grid->GetFaceLocations());
  Forms forms;
  for (std::int64_t i = 0; i < cells.size(); ++i)
  {
    const int type = types->GetValue(i);
    const std::size_t corners = cells[i].size();
    const auto points = forms.points(type);
    if (!points)
      fail(name, fmt::format("cell {} is of type {}, which isn't taken", i, type),
        "cut it into tetrahedra (vtkDataSetTriangleFilter, ParaView's Tetrahedralize)");
    if (*points > 0 ? *points != corners : corners < fewest_points(type))
      fail(name, fmt::format("cell {} of type {} has {} points", i, type, corners), "mend it");
    for (const std::int64_t point : cells[i])
      if (point < 0 || point >= grid->GetNumberOfPoints())
        fail(name, fmt::format("cell {} has a point {} that there isn't", i, point), "mend it");
    if (type == VTK_POLYHEDRON)
      check_faces(faces, i < static_cast<std::int64_t>(first_face.size()) ? first_face[i] : -1,
        grid->GetNumberOfPoints(), i, name);
  }
}

void require_finite(double place, const std::string& name)
{
  if (!(std::abs(place) <= greatest_coordinate))
    fail(name, fmt::format("has a place {}", place), "write it anew");
}

void require_places(vtkIdType there, vtkIdType needed, const std::string& name)
{
  if (there != needed)
    fail(name, fmt::format("has {} places for the {} points of its dimensions", there, needed),
      "write it anew");
}

void check_points(vtkPointSet* data, const std::string& name)
{
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    for (int c = 0; c < 3; ++c)
      require_finite(data->GetPoints()->GetData()->GetComponent(i, c), name);
}

void check_axis(vtkDataArray* along, int points, int axis, const std::string& name)
{
  require_places(along ? along->GetNumberOfValues() : 0, points, name);
  for (int i = 0; i < points; ++i)
  {
    require_finite(along->GetComponent(i, 0), name);
    if (i > 0 && along->GetComponent(i, 0) < along->GetComponent(i - 1, 0))
      fail(name, fmt::format("its places along axis {} don't ascend", axis), "turn them round");
  }
}

void check_image(vtkImageData* image, const std::string& name)
{
  for (int i = 0; i < 6; ++i)
    require_finite(image->GetBounds()[i], name);
  for (int axis = 0; axis < 3; ++axis)
    if (image->GetSpacing()[axis] == 0)
      fail(name, "a spacing is 0", "write it anew");
}

}

void check_grid(vtkDataSet* data, const std::string& name)
{
  if (auto* image = vtkImageData::SafeDownCast(data))
    check_image(image, name);
  else if (auto* grid = vtkRectilinearGrid::SafeDownCast(data))
  {
    const int* n = grid->GetDimensions();
    check_axis(grid->GetXCoordinates(), n[0], 0, name);
    check_axis(grid->GetYCoordinates(), n[1], 1, name);
    check_axis(grid->GetZCoordinates(), n[2], 2, name);
  }
  else if (auto* structured = vtkStructuredGrid::SafeDownCast(data))
  {
    const int* n = structured->GetDimensions();
    require_places(
      structured->GetNumberOfPoints(), static_cast<vtkIdType>(n[0]) * n[1] * n[2], name);
    check_points(structured, name);
  }
  else if (auto* cells = vtkUnstructuredGrid::SafeDownCast(data))
  {
    check_points(cells, name);
    check_cells(cells, name);
  }
  else
    fail(name, fmt::format("is a {}", data->GetClassName()),
      "give an image or a grid that fills a volume");
}

}
