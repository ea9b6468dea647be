#include "MeshConversion.h"

#include "solver/Errors.h"

#include "vtkAppendPolyData.h"
#include "vtkCleanPolyData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <fmt/format.h>

namespace vesicle
{
namespace
{

/// Points at exactly the same place become one.
vtkSmartPointer<vtkPolyData> without_seams(vtkPolyData* surface)
{
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputData(surface);
  clean->SetTolerance(0);
  clean->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  clean->ConvertPolysToLinesOff();
  clean->Update();
  return clean->GetOutput();
}

}

vtkSmartPointer<vtkPolyData> joined(vtkCompositeDataSet* blocks, const std::string& name)
{
  vtkNew<vtkAppendPolyData> append;
  append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  vtkSmartPointer<vtkPolyData> first;
  auto block = vtk::TakeSmartPointer(blocks->NewIterator());
  for (block->InitTraversal(); !block->IsDoneWithTraversal(); block->GoToNextItem())
  {
    const auto surface = without_ghosts(triangulated(block->GetCurrentDataObject(),
      fmt::format("{}, block {}", name, block->GetCurrentFlatIndex())));
    append->AddInputData(surface);
    if (!first)
      first = surface;
  }
  if (!first)
    throw InputError(name + ": has no blocks; a mesh of triangles is needed");
  append->Update();
  auto all = without_seams(append->GetOutput());
  all->GetFieldData()->ShallowCopy(first->GetFieldData());
  return all;
}

}
