#include "MeshConversion.h"

#include "ArrayLabels.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkCleanPolyData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <vector>

namespace vesicle
{
namespace
{

std::vector<FrameArray> to_frame_arrays(vtkFieldData* data)
{
  std::vector<FrameArray> arrays;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i); // nullptr: not numbers
    if (!array || !array->GetName())
    {
      continue;
    }
    FrameArray::Values values(array->GetNumberOfTuples(), array->GetNumberOfComponents());
    for (Eigen::Index row = 0; row < values.rows(); ++row)
    {
      array->GetTuple(row, values.row(row).data());
    }
    arrays.push_back({ array->GetName(), std::move(values) });
  }
  return arrays;
}

bool uses_all_points(vtkPolyData* surface)
{
  const auto mesh = to_mesh(surface);
  std::vector<bool> used(mesh.points.rows(), false);
  for (const int vertex : mesh.triangles.reshaped())
  {
    used[vertex] = true;
  }
  return std::find(used.begin(), used.end(), false) == used.end();
}

}

TriangleMesh to_mesh(vtkPolyData* surface)
{
  TriangleMesh mesh;
  mesh.points.resize(surface->GetNumberOfPoints(), 3);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    surface->GetPoint(i, mesh.points.row(i).data());
  }
  std::vector<std::array<int, 3>> corners;
  auto cells = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* ids;
    cells->GetCurrentCell(size, ids);
    if (size == 3)
    {
      corners.push_back(
        { static_cast<int>(ids[0]), static_cast<int>(ids[1]), static_cast<int>(ids[2]) });
    }
  }
  mesh.triangles.resize(static_cast<Eigen::Index>(corners.size()), 3);
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    mesh.triangles.row(i) << corners[i][0], corners[i][1], corners[i][2];
  }
  return mesh;
}

vtkSmartPointer<vtkPoints> to_vtk_points(const Points& points)
{
  auto result = vtkSmartPointer<vtkPoints>::New();
  result->SetDataTypeToDouble();
  result->SetNumberOfPoints(points.rows());
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    result->SetPoint(i, points(i, 0), points(i, 1), points(i, 2));
  }
  return result;
}

void use_double_points(vtkPolyData* surface)
{
  if (surface->GetPoints() && surface->GetPoints()->GetDataType() == VTK_DOUBLE)
  {
    return;
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  if (surface->GetPoints())
  {
    points->DeepCopy(surface->GetPoints());
  }
  surface->SetPoints(points);
}

vtkSmartPointer<vtkCellArray> to_cells(const Triangles& triangles)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->AllocateExact(triangles.rows(), triangles.size());
  for (const auto& triangle : triangles.rowwise())
  {
    cells->InsertNextCell({ triangle[0], triangle[1], triangle[2] });
  }
  return cells;
}

vtkSmartPointer<vtkPolyData> to_polydata(const TriangleMesh& mesh)
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(to_vtk_points(mesh.points));
  surface->SetPolys(to_cells(mesh.triangles));
  return surface;
}

vtkSmartPointer<vtkDoubleArray> to_array(const std::string& name, const Eigen::MatrixXd& values)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name.c_str());
  array->SetNumberOfComponents(static_cast<int>(values.cols()));
  array->SetNumberOfTuples(values.rows());
  for (Eigen::Index i = 0; i < values.rows(); ++i)
  {
    for (Eigen::Index j = 0; j < values.cols(); ++j)
    {
      array->SetTypedComponent(i, static_cast<int>(j), values(i, j));
    }
  }
  label(array);
  return array;
}

Frame to_frame(vtkPolyData* surface, double time)
{
  return { time, to_mesh(surface), to_frame_arrays(surface->GetPointData()),
    to_frame_arrays(surface->GetCellData()), to_frame_arrays(surface->GetFieldData()) };
}

vtkSmartPointer<vtkUnstructuredGrid> to_unstructured_grid(vtkPolyData* surface)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(surface->GetPoints());
  grid->SetCells(VTK_TRIANGLE, surface->GetPolys());
  grid->GetPointData()->ShallowCopy(surface->GetPointData());
  grid->GetCellData()->ShallowCopy(surface->GetCellData());
  grid->GetFieldData()->ShallowCopy(surface->GetFieldData());
  return grid;
}

vtkSmartPointer<vtkPolyData> membrane_of(vtkDataObject* input, const std::string& name)
{
  auto surface = without_ghosts(triangulated(input, name));
  if (surface->GetNumberOfPolys() == 0 || uses_all_points(surface))
  {
    return surface;
  }
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputData(surface);
  clean->PointMergingOff();
  clean->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  clean->Update();
  return clean->GetOutput();
}

}
